#pragma once

#include <span>
#include <vector>

namespace keiko {

/// Every root in the open interval (0, 1) of a polynomial given by its Bernstein coefficients,
/// rising. Coefficients up to `noise` in size count as zero. Subdivision by sign variation
/// [LaneRiesenfeld1981] misses no simple root. A multiple root is returned once or twice, as
/// accurately as `noise` permits. It is missed if rounding beyond `noise` has lifted it off zero.
/// An interval on which the polynomial is zero throughout has none.
std::vector<double> bernstein_roots(std::span<const double> coefficients, double noise);

} // namespace keiko
