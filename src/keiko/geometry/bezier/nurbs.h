#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <vector>

namespace KEIKO_API keiko {

/// A B-spline curve with homogeneous control points `P` (Vec3 for plane curves, Vec4 in space).
/// Not periodic; knots are written out with their multiplicity: points + degree + 1 of them.
template <class P>
struct NurbsCurve {
    int degree = 0;            ///< at least 1
    std::vector<double> knots; ///< never falling
    std::vector<P> points;     ///< homogeneous
};

/// A polynomial or rational segment between two knots that differ.
template <class P>
struct BezierSpan {
    double begin = 0;      ///< knot at which it begins
    double end = 1;        ///< knot at which it ends, greater than `begin`
    std::vector<P> points; ///< degree + 1
};

/// Splits a B-spline curve into its Bezier segments by knot insertion [Boehm1980]; neighbouring
/// segments share their end point bit for bit. Works on the knots from knots[degree] to
/// knots[points.size()], the valid domain of clamped and unclamped curves.
template <class P>
std::vector<BezierSpan<P>> bezier_spans(NurbsCurve<P> curve);

extern template std::vector<BezierSpan<Vec3>> bezier_spans(NurbsCurve<Vec3>); ///< plane curves
extern template std::vector<BezierSpan<Vec4>> bezier_spans(NurbsCurve<Vec4>); ///< in space

/// A B-spline surface; u is the outer index of `points`.
struct NurbsSurface {
    int degree_u = 0;            ///< at least 1
    int degree_v = 0;            ///< at least 1
    std::vector<double> knots_u; ///< never falling, count_u() + degree_u + 1
    std::vector<double> knots_v; ///< never falling, count_v() + degree_v + 1
    std::vector<Vec4> points;    ///< homogeneous, count_u() x count_v()

    /// Number of control points along u.
    std::size_t count_u() const { return knots_u.size() - static_cast<std::size_t>(degree_u) - 1; }
    /// Number of control points along v.
    std::size_t count_v() const { return knots_v.size() - static_cast<std::size_t>(degree_v) - 1; }
};

/// One Bezier patch of a B-spline surface and the knot rectangle it covers.
struct BezierPatchSpan {
    double u_begin = 0;       ///< knot of u at which it begins
    double u_end = 1;         ///< knot of u at which it ends
    double v_begin = 0;       ///< knot of v at which it begins
    double v_end = 1;         ///< knot of v at which it ends
    std::vector<Vec4> points; ///< (degree_u + 1) x (degree_v + 1), u outer
};

/// Splits a B-spline surface into its Bezier patches, u spans outer; neighbouring patches share
/// their border control points bit for bit.
std::vector<BezierPatchSpan> bezier_spans(const NurbsSurface& surface);

} // namespace keiko
