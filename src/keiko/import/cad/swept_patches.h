#pragma once

#include "keiko/import/cad/curve_span.h"
#include "keiko/import/cad/surface_patches.h"

namespace keiko::cad {

/// An axis of revolution with right-handed angles about `direction`, or left-handed ones.
struct Axis {
    Vec3 origin{0}, direction{0, 0, 1}; ///< unit direction
    bool left_handed = false;
};

/// Surface of revolution: u is the angle, begin..end in radians; v runs along `profile`, which
/// is its meridian at u = 0.
std::vector<SurfacePatch> revolved(const Axis& axis, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile);

/// Linear extrusion: u runs along `profile`, v is the way along `direction` (any length).
std::vector<SurfacePatch> extruded(const Vec3& direction, double begin, double end,
                                   const std::vector<CurveSpan<Vec4>>& profile);

} // namespace keiko::cad
