#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/math/vec.h"

namespace keiko {

/// The worst value of one quantity along a seam or over a face.
struct MeasuredValue {
    double value = 0;
    double bound = 0; ///< the exact worst lies within this of the value
    double limit = 0;
    Vec3 place{0}; ///< world, mm
    Verdict verdict = Verdict::pass;
    bool at_least = false; ///< the limit is the smallest value allowed, not the largest
};

/// Ratio of a value to its limit: 1 at the limit, more beyond it.
inline double share_of_limit(const MeasuredValue& worst) {
    return worst.at_least ? worst.limit / worst.value : worst.value / worst.limit;
}

} // namespace keiko
