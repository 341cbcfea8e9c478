#pragma once

#include "keiko/geometry/model/surface_curve.h"

namespace keiko {

/// The point of a curve that is nearest to a given one.
struct ClosestPoint {
    double t = 0;
    SurfaceCurve::Point point;
    double distance = 0; ///< mm
    double slip = 0; ///< mm along the tangent by which the foot is not square: the curve has ended
};

/// Nearest point by Newton's iteration from `guess` on (C(t) - p) . C'(t) = 0 within [begin, end].
ClosestPoint closest_point(const SurfaceCurve& curve, const Vec3& p, double guess, double begin = 0,
                           double end = 1);

} // namespace keiko
