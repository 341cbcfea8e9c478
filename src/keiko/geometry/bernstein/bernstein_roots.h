#pragma once

#include <span>
#include <vector>

namespace keiko {

/// Every root in the open interval (0, 1) of a polynomial given by its Bernstein coefficients,
/// rising. Coefficients up to `noise` in size count as zero. Subdivision by sign variation
/// [LaneRiesenfeld1981]: no simple root is missed. A multiple root is given once or twice, as near
/// as `noise` tells, and not at all where rounding beyond `noise` has lifted it off zero; an
/// interval on which the polynomial is zero throughout has none.
std::vector<double> bernstein_roots(std::span<const double> coefficients, double noise);

} // namespace keiko
