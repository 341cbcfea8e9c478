#pragma once

#include "keiko/geometry/seam/boundary_curves.h"

namespace keiko::test {

/// mm, at which borders are joined.
constexpr double join = 0.5;
/// Sides of sheets, mm.
inline const Vec3 along_x(100, 0, 0), up_y(0, 50, 0), down_y(0, -50, 0);

inline double length_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).length(i.begin, i.end);
}

inline Vec3 begin_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).at(i.begin).position;
}

inline Vec3 end_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).at(i.end).position;
}

} // namespace keiko::test
