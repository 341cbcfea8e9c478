#pragma once

#include <vector>

namespace keiko {

/// Places of a stretch at which what changes along it like a polynomial of a degree below `count`
/// is sampled, in (0, 1), rising: the Chebyshev nodes. Such a polynomial that is near 0 at all of
/// them is near 0 all along.
std::vector<double> isoline_places(int count);

} // namespace keiko
