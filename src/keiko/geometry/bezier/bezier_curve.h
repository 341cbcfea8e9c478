#pragma once

#include "keiko/math/bounds.h"

#include <array>
#include <span>

namespace keiko {

/// View of a plane Bezier curve over [0, 1], rational or not: a piece of a p-curve.
struct BezierCurveView {
    /// degree + 1 homogeneous control points (w x, w y, w).
    std::span<const Vec3> points;

    int degree() const { return static_cast<int>(points.size()) - 1; }
};

/// Point and derivatives by the curve parameter: [0] the point, [1] .. [order] the derivatives.
/// Requires order <= 3; entries above it are 0.
std::array<Vec2, 4> evaluate(const BezierCurveView& curve, double t, int order);

/// Box of the control points, which holds the curve if all weights are positive.
Box2 hull_bounds(const BezierCurveView& curve);

} // namespace keiko
