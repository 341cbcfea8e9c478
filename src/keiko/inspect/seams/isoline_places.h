#pragma once

#include <vector>

namespace keiko {

/// Places of a stretch, in (0, 1), rising, at which a quantity is sampled that varies along it like
/// a polynomial of a degree below `count`: the Chebyshev nodes. Such a polynomial that is near 0 at
/// all of them is near 0 all along.
std::vector<double> isoline_places(int count);

} // namespace keiko
