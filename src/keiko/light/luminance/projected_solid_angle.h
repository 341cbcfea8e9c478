#pragma once

#include "keiko/light/luminance/disc.h"
#include "keiko/math/vec.h"

#include <span>

namespace keiko {

/// Projected solid angle in sr, 0 to pi, of the part of a planar polygon that lies above the
/// horizon N.(Q - P) = 0 of `point` with unit normal `normal`. Times the polygon's uniform
/// luminance it is the illuminance in lx; divided by pi it is the form factor of a surface element.
/// Lambert's boundary sum [Lambert1760] (docs/theory/luminance.md#planar-polygons-and-discs), to
/// 1e-11. Corners are in either order, and both faces count. It is 0 for fewer than three corners
/// and for a polygon viewed edge-on. Any unit of length.
double projected_solid_angle(std::span<const Vec3> corners, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of the part of a disc that lies above the horizon of
/// `point` with unit `normal`. Both faces of the disc count; 0 if it is viewed edge-on. Stokes'
/// integral N.(r x dr) / r^2 along the rim in closed form
/// (docs/theory/luminance.md#planar-polygons-and-discs), and along the chord in which the tangent
/// plane cuts the disc; to 1e-11.
double projected_solid_angle(const Disc& disc, const Vec3& point, const Vec3& normal);

/// A piece of a straight line viewed from a surface element. Positions x along the line count from
/// the foot of the element. Its unit normal has the components `n_along` along the line and
/// `n_line` towards the foot. Lengths are in one unit of any kind.
struct LinePiece {
    double begin = 0, end = 0;      ///< x of both ends; empty unless begin < end
    double distance = 0;            ///< of the element from the line, > 0
    double n_along = 0, n_line = 0; ///< components of the normal, each from -1 to 1
};

/// The piece above the element's horizon; empty (begin >= end) if there is none.
LinePiece above_horizon(const LinePiece& piece);

/// Integral of (N.w) cos(angle to the perpendicular) / r^2 along a piece that lies above the
/// horizon, in one over the unit of length, to 1e-11. Times the intensity per length across the
/// line, in cd/m, it is the illuminance of a thin diffuse tube, the line source of [Nishita1985]
/// (docs/theory/luminance.md#the-ladder-of-approximations).
double cosine_line_integral(const LinePiece& piece);

} // namespace keiko
