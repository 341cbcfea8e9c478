#pragma once

#include "keiko/math/taylor_model.h"
#include "keiko/math/vec.h"

namespace keiko {

/// How high a function may reach over [-1, 1]^2, and where that is likely.
struct TaylorPeak {
    double bound = 0; ///< the function is nowhere larger
    Vec2 place{0};    ///< where its quadratic part is largest
};

/// The largest value of the quadratic part, which is exact, with the rest added. Infinite for an
/// unknown model.
TaylorPeak peak(const TaylorModel& model);

} // namespace keiko
