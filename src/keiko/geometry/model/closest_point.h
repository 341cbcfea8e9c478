#pragma once

#include "keiko/geometry/model/surface_curve.h"

#include <vector>

namespace keiko {

/// A curve in space as a polyline that stays near it: for searching, never for measuring.
struct CurvePolyline {
    std::vector<double> t;    ///< rising from 0 to 1
    std::vector<Vec3> points; ///< of the curve at t
    double deviation = 0;     ///< mm, about the largest distance between curve and polyline
    double length = 0;        ///< mm
    double turn = 0;          ///< radians, about the largest angle between curve and its chord

    Box3 box() const; ///< of the curve
    /// Distance of a point to the polyline, mm.
    double distance(const Vec3& p) const;
    /// Parameter of approximately the point of the curve that is nearest to p.
    double nearest(const Vec3& p) const;
};

/// Halves the curve until the chords are within `chord_error` mm of it and turn little.
CurvePolyline make_polyline(const SurfaceCurve& curve, double chord_error);

/// Parameter in [0, 1] of the point of the segment p0 p1 that is nearest to p; 0 if the segment is
/// a point.
double nearest_on_segment(const Vec3& p0, const Vec3& p1, const Vec3& p);
/// Distance in mm between a point and the segment p0 p1.
double segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& p);

/// Closest approach of two segments.
struct SegmentApproach {
    double distance = 0; ///< mm
    double share = 0;    ///< position along the first one, 0 to 1
};

/// Closest approach of the segments p0 p1 and q0 q1.
SegmentApproach segment_approach(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

/// The point of a curve that is nearest to a given one.
struct ClosestPoint {
    double t = 0;              ///< parameter of the curve
    SurfaceCurve::Point point; ///< of the curve at t
    double distance = 0;       ///< mm
    double slip = 0; ///< mm along the tangent by which the foot is not square: the curve has ended
};

/// Nearest point by Newton's iteration from `guess` on (C(t) - p) . C'(t) = 0 within [begin, end].
ClosestPoint closest_point(const SurfaceCurve& curve, const Vec3& p, double guess, double begin = 0,
                           double end = 1);

} // namespace keiko
