#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"

#include <vector>

namespace keiko {

/// A place on a walk.
struct WalkPoint {
    SheetPoint at;
    Vec3 position{0};  ///< world, mm
    double length = 0; ///< mm gone
    double bend = 0;   ///< 1/mm, normal curvature along the way, by the normal of the first place
};

/// A walk straight on over smooth faces.
struct GeodesicTrace {
    std::vector<WalkPoint> points; ///< in equal steps; the first is where it begins
    bool ended = false;            ///< material ended before the reach
};

/// About along a geodesic from a place in a direction, in steps of `step` mm along the surface, as
/// far as `reach` mm; where material ends before, with `to_border`, a last shorter step leads to
/// its border. No points at a pole.
GeodesicTrace walk_straight(const FaceAdjacency& faces, const SheetPoint& from,
                            const Vec3& direction, double step, double reach, bool to_border);

} // namespace keiko
