#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <array>
#include <vector>

namespace keiko {

/// Part of a Bezier patch over a box of its parameters, with its own control points.
class PatchBox {
public:
    /// The whole patch.
    explicit PatchBox(const BezierPatchView& patch);

    /// The box, in parameters of the patch.
    const Box2& uv() const { return uv_; }
    /// Its parts below and above a share of its range, 0 to 1; `by_u`: cut across u.
    std::array<PatchBox, 2> parts(bool by_u, double share) const;
    /// Either half.
    std::array<PatchBox, 2> halves(bool by_u) const { return parts(by_u, 0.5); }

    /// Rounding error of the coordinates of its own control points, mm.
    double rounding() const;
    /// View of its own control points, which the box must outlive.
    BezierPatchView view() const { return {degree_u_, degree_v_, points_}; }

private:
    PatchBox(int degree_u, int degree_v, const Box2& uv, std::vector<Vec4> points)
        : degree_u_(degree_u), degree_v_(degree_v), uv_(uv), points_(std::move(points)) {}

    int degree_u_, degree_v_;
    Box2 uv_;
    std::vector<Vec4> points_; ///< homogeneous, u outer
};

/// Lengths of the sides of a patch's control polygons along u and along v, times the degree, mm.
/// Each is at least the patch's length in that direction, if the patch is not rational.
std::array<double, 2> net_extents(const BezierPatchView& patch);

} // namespace keiko
