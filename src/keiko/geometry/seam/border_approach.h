#pragma once

#include "keiko/base/units.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/math/interval_set.h"

#include <vector>

namespace keiko {

/// Radians: borders that diverge faster than this cross or touch; they do not form a seam.
constexpr double parallel_borders = degrees_to_radians(10);
/// True if the sine of the angle between two directions is at most `sine`.
bool nearly_parallel(const Vec3& a, const Vec3& b, double sine);

/// Places where a border comes near another, by their chords; parameters of the first.
struct BorderApproach {
    IntervalSet close; ///< runs of segments that come near any of the other, nearly parallel
    /// Parameters inside such segments at which a segment of the other is nearest, rising.
    std::vector<double> nearest;
};

/// Approach of `a` to `b`, within `join` mm.
BorderApproach border_approach(const CurvePolyline& a, const CurvePolyline& b, double join);

} // namespace keiko
