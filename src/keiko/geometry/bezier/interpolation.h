#pragma once

#include "keiko/geometry/bezier/nurbs.h"

#include <span>

namespace keiko {

/// A curve through points, and how far it leaves the polyline through them.
struct InterpolatedCurve {
    NurbsCurve<Vec4> curve; ///< weights are 1; knots are mm along the chords
    double departure = 0;   ///< mm: bound of its distance from the chords between its points
};

/// The polyline through points as a B-spline of degree 1. It leaves out points that repeat the one
/// before. Needs two points that differ.
InterpolatedCurve interpolating_polyline(std::span<const Vec3> points);

/// The cubic B-spline through points with continuous curvature, its knots at their distances along
/// the chords. Its end tangents are those of the parabolas through the outermost three points
/// [DeBoor1978, ch. IV]. Two points give the straight line between them, of degree 1. It leaves out
/// points that repeat the one before. Needs two points that differ.
InterpolatedCurve interpolating_spline(std::span<const Vec3> points);

} // namespace keiko
