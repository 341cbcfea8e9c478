#pragma once

#include <limits>

namespace keiko {

/// By how much rounding blurs the place where a ray meets a sub-patch's frame, for each mm of the
/// way there. With u = 2^-53 the unit roundoff: start - center costs u, each product of a row 3 u,
/// the unit direction 3 u and its rows 3 u more, the quotients 2 u, the last step 1 u; in sum 13 u
/// of numbers no larger than the way, times a weight of at most 1.5. 32 u sub-patches room for
/// products.
constexpr double ray_rounding = 16 * std::numeric_limits<double>::epsilon();

} // namespace keiko
