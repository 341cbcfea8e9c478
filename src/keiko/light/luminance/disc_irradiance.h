#pragma once

#include "keiko/math/vec.h"

namespace keiko {

/// A flat round disc; `normal` is the unit vector of its face, lengths in one unit of any kind.
struct Disc {
    Vec3 center{0}, normal{0, 0, 1};
    double radius = 0;
};

/// Projected solid angle in sr, 0 to pi, of the part of a disc that lies above the horizon of
/// `point` with unit `normal`; both faces of the disc count, 0 where it is seen edge-on. Stokes'
/// integral N.(r x dr) / r^2 along the rim in closed form
/// (docs/theory/luminance.md#planar-polygons-and-discs), and along the chord in which the tangent
/// plane cuts the disc; to 1e-11.
double projected_solid_angle(const Disc& disc, const Vec3& point, const Vec3& normal);

} // namespace keiko
