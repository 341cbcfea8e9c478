#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <optional>

namespace keiko {

/// Curvature of a curve on a surface at one place.
struct CurveBend {
    double curvature = 0; ///< 1/mm, of the section itself, or of an iso-curve's normal section
    double normal_curvature = 0; ///< 1/mm, of the surface along the curve
    /// Unit vector to which the curve bends where its curvature is positive: the surface's normal,
    /// or the normalised part of it in the plane of a section.
    Vec3 towards{0};
};

/// Reverses the side to which the curvature refers.
inline void turn_over(CurveBend& bend) {
    bend.curvature = -bend.curvature, bend.towards = -bend.towards;
}

/// The curvature of a curve at a place of the surface with the unit normal `outward`, along u' and
/// v' of `direction`: the normal curvature II / I.
std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction);

/// The curvature of the curve in which a plane with the unit normal `plane` cuts the surface. It is
/// k / cos (Meusnier), with k the normal curvature along the curve and the angle between the
/// surface's normal and the plane. nullopt if the plane is almost tangent to the surface.
std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane);

/// The curve's own curvature in a plane that is tangent to the surface all along it, where the
/// surface is as flat as the plane. `direction` is its direction in u and v, `turning` the
/// derivative of that along it. `towards` is to the left, viewed from the side that the plane's
/// unit normal points to. nullopt if the direction is 0.
std::optional<CurveBend> touching_bend(const SurfaceDerivatives& s, const Vec3& plane,
                                       const Vec2& direction, const Vec2& turning);

} // namespace keiko
