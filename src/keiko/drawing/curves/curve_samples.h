#pragma once

#include "keiko/geometry/model/surface_curve.h"

#include <vector>

namespace keiko {

/// A curve on a surface by points of it.
struct CurveSamples {
    std::vector<double> t;    ///< parameters of the curve, rising or falling
    std::vector<Vec3> points; ///< at these, world, mm
};

/// Points of a curve between two of its parameters, in either order, its patch changes among them.
/// Chords are within `chord_error` mm of it, as far as three places between their ends tell.
CurveSamples sampled(const SurfaceCurve& curve, double begin, double end, double chord_error);

} // namespace keiko
