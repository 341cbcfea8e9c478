#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <array>
#include <vector>

namespace keiko {

/// Bounds over a whole sub-patch of one homogeneous component less its affine part.
struct ComponentBounds {
    double value = 0; ///< of |e|
    double slope = 0; ///< of |e_x| + |e_y|
    double bend = 0;  ///< of |e_xx| + 2 |e_xy| + |e_yy|
};

/// Coordinates (X, Y, Z) = rows * (P - center) in which a piece of surface is nearly the square
/// [-1, 1]^2 of the plane Z = 0. Let x = 2 u - 1 and y = 2 v - 1, and the weight w be scaled to
/// about 1. Its homogeneous components are there
///   w X = x + e_u(x, y),  w Y = y + e_v(x, y),  w Z = e_n(x, y),  w = 1 + e_w(x, y).
struct SubPatchFrame {
    /// The mean tangents span a plane, and the scaled weights differ from 1 by less than 0.5. Else
    /// only `length`, `bend_u`, `bend_v` and `twist` mean anything.
    bool regular = false;
    Vec3 center{0};                                      ///< where X = Y = Z = 0, mm
    std::array<Vec3, 3> rows{Vec3(0), Vec3(0), Vec3(0)}; ///< 1 / mm
    Vec2 length{0};             ///< mm, mean of the edges along u and along v
    double weight_scale = 1;    ///< what the homogeneous components are multiplied by
    ComponentBounds u, v, n, w; ///< of e_u, e_v, e_n and e_w
    double height = 0;          ///< bound of |Z|
    /// Bend that halving u flattens, that halving v flattens, and that both must share.
    double bend_u = 0, bend_v = 0, twist = 0;

    /// For rays up to 60 degrees off the frame's normal: estimate of how far the function whose
    /// zero is sought, preconditioned by the frame, is from the identity. It only guides the
    /// splitting; the proof is made ray by ray (docs/theory/intersector.md). Infinite for a frame
    /// that is not regular.
    double contraction() const;
};

/// Frame of a piece of surface. The control points of `sub_patch` are relative to a place near it;
/// large coordinates would round the bounds.
SubPatchFrame sub_patch_frame(const BezierPatchView& sub_patch);

/// The homogeneous components of a sub-patch in its frame by powers of x and y. Entry
/// i * (degree_v + 1) + j holds the coefficients of x^i y^j in (w X, w Y, w Z, w).
struct SubPatchPolynomial {
    std::vector<std::array<double, 4>> coefficients; ///< one a control point
    /// Bound of the error of any component when evaluated by Horner's scheme in double precision
    /// within [-1, 1]^2, fused or not: by the change to powers and by using them. (What turning the
    /// control points into the frame costs is in PackedSubPatch::blur.)
    std::array<double, 4> rounding{};
};

/// Components of a piece of surface in its frame, by powers. Requires a regular frame.
SubPatchPolynomial sub_patch_polynomial(const BezierPatchView& sub_patch,
                                        const SubPatchFrame& frame);

} // namespace keiko
