#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/math/bounds.h"

#include <array>
#include <span>

namespace KEIKO_API keiko {

/// View of a plane Bezier curve over [0, 1], rational or not: a piece of a p-curve.
struct BezierCurveView {
    /// degree + 1 homogeneous control points (w x, w y, w).
    std::span<const Vec3> points;

    /// One less than the number of control points.
    int degree() const { return static_cast<int>(points.size()) - 1; }
};

/// Point and derivatives by the curve parameter: [0] the point, [1] .. [order] the derivatives.
/// Requires order <= 3; entries above it are 0.
std::array<Vec2, 4> evaluate(const BezierCurveView& curve, double t, int order);

/// Box of the control points, which holds the curve if all weights are positive.
Box2 hull_bounds(const BezierCurveView& curve);

/// View of a tensor-product Bezier patch over [0, 1]^2, rational or not.
struct BezierPatchView {
    int degree_u = 0, degree_v = 0; ///< of the two parameters
    /// (degree_u + 1) x (degree_v + 1) homogeneous control points, u outer.
    std::span<const Vec4> points;

    /// Control point i in u, j in v; homogeneous.
    const Vec4& point(int i, int j) const {
        const int index = i * (degree_v + 1) + j;
        return points[static_cast<std::size_t>(index)];
    }
    /// True if any two weights differ.
    bool rational() const;
};

/// S and its partial derivatives by the patch's own parameters: d[k][l] = d^(k+l) S / du^k dv^l.
struct SurfaceDerivatives {
    std::array<std::array<Vec3, 4>, 4> d; ///< d[i][j]: derivative i times by u and j times by v

    /// All zero.
    SurfaceDerivatives() {
        for (auto& row : d) row.fill(Vec3(0));
    }

    /// S itself.
    const Vec3& position() const { return d[0][0]; }
    /// First derivative by u.
    const Vec3& du() const { return d[1][0]; }
    /// First derivative by v.
    const Vec3& dv() const { return d[0][1]; }
    /// Second derivative by u.
    const Vec3& duu() const { return d[2][0]; }
    /// Mixed second derivative.
    const Vec3& duv() const { return d[1][1]; }
    /// Second derivative by v.
    const Vec3& dvv() const { return d[0][2]; }
};

/// All derivatives with k + l <= order (0 to 3); rational ones by the quotient rule
/// [PieglTiller1997, algorithm A4.4]. The other entries are 0.
SurfaceDerivatives evaluate(const BezierPatchView& patch, const Vec2& uv, int order);

/// Box of the control points, which holds the patch if all weights are positive.
Box3 hull_bounds(const BezierPatchView& patch);

} // namespace keiko
