#pragma once

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/flaws/face_adjacency.h"

#include <vector>

namespace keiko {

/// A point of a geodesic trace.
struct WalkPoint {
    SheetPoint at;     ///< on one of the faces
    Vec3 position{0};  ///< world, mm
    double length = 0; ///< mm traced
    SecondForm bend;   ///< 1/mm, x along the trace, by the normal of the first place
    Vec3 normal{0};    ///< unit, continued from the first place
};

/// A straight trace over smooth faces.
struct GeodesicTrace {
    std::vector<WalkPoint> points; ///< in equal steps; the first is where it begins
    bool ended = false;            ///< material ended before the reach
};

/// Approximate geodesic from a place in a direction, in steps of `step` mm along the surface, as
/// far as `reach` mm. If material ends before, with `to_border`, a last shorter step leads to its
/// border. No points where the surface has no normal.
GeodesicTrace walk_straight(const FaceAdjacency& faces, const SheetPoint& from,
                            const Vec3& direction, double step, double reach, bool to_border);

} // namespace keiko
