#pragma once

#include "keiko/geometry/bezier/ray.h"

namespace keiko {

/// A ray as it is traced: its start moved up to the ball around the scene, so that what single
/// precision and cancellation cost stays small against the scene however far off the eye is.
struct TracedRay {
    const Ray* ray = nullptr;
    Vec3 start{0};      ///< world, mm
    Vec3 direction{0};  ///< unit
    double t_start = 0; ///< of the ray, at `start`
    double speed = 1;   ///< mm in one unit of t
    double error = 0;   ///< mm, bound of the distance of `start` to the exact ray
    /// mm from `start`: the part of [t_min, t_max] within the ball, wider by at most `slack`, the
    /// rounding between s and t.
    double low = 0, high = 0, slack = 0;

    double t_at(double s) const { return t_start + s / speed; }
};

} // namespace keiko
