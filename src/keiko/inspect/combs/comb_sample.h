#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <optional>

namespace keiko {

/// How a curve on a surface bends at one place.
struct CurveBend {
    double curvature = 0; ///< 1/mm, of the section itself, or of an iso-curve's normal section
    double normal_curvature = 0; ///< 1/mm, of the surface along the curve
    /// Unit; towards it the curve bends where its curvature is positive: the surface's normal, or
    /// what of it lies in the plane of a section.
    Vec3 towards{0};
};

/// The same bend, told towards the other side.
inline void turn_over(CurveBend& bend) {
    bend.curvature = -bend.curvature, bend.towards = -bend.towards;
}

/// The bend of a curve at a place of the surface with the unit normal `outward`, run along u' and
/// v' of `direction`: the normal curvature II / I.
std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction);

/// The bend of the curve in which a plane with the unit normal `plane` cuts the surface: k / cos,
/// with k the normal curvature along it and the angle between the surface's normal and the plane
/// (Meusnier). Nothing where the plane is all but tangent to the surface.
std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane);

/// The bend of a curve that lies in a plane tangent to the surface all along it: of its own, for
/// the surface along it is as flat as the plane. `direction` is the way it runs in u and v,
/// `turning` the derivative of that along it; `towards` is to the left, seen from where the plane's
/// unit normal points to. Nothing where the direction is 0.
std::optional<CurveBend> touching_bend(const SurfaceDerivatives& s, const Vec3& plane,
                                       const Vec2& direction, const Vec2& turning);

} // namespace keiko
