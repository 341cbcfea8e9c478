#pragma once

#include "keiko/geometry/seam/border_run.h"
#include "keiko/math/interval_set.h"

#include <vector>

namespace keiko {

/// Places where a border comes near another, by their chords; parameters of the first.
struct BorderApproach {
    IntervalSet close; ///< runs of segments that come near any of the other and may run alike
    /// Parameters inside such segments at which a segment of the other is nearest, rising.
    std::vector<double> nearest;
};

/// Approach of `a` to `b`, within `join` mm.
BorderApproach border_approach(const Border& a, const Border& b, double join);

} // namespace keiko
