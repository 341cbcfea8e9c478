#pragma once

#include "keiko/math/vec.h"

#include <span>

namespace keiko {

/// Projected solid angle in sr, 0 to pi, of the part of a planar polygon that lies above the
/// horizon N.(Q - P) = 0 of `point` with unit normal `normal`; times the polygon's uniform
/// luminance it is the illuminance in lx, divided by pi the form factor of a surface element.
/// Lambert's boundary sum [Lambert1760] (docs/theory/luminance.md#planar-polygons-and-discs), to
/// 1e-11. Corners in either order, both faces count, 0 for fewer than three corners and for a
/// polygon seen edge-on. Any unit of length.
double projected_solid_angle(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal);

} // namespace keiko
