#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/light/luminance/projected_solid_angle.h"
#include "keiko/math/vec.h"

namespace keiko {

/// A flat ellipse in space: the places center + p cos s + q sin s.
struct Ellipse {
    Vec3 center{0};  ///< mm
    Vec3 p{0}, q{0}; ///< mm, conjugate half-diameters

    /// Normal of its plane, of any length.
    Vec3 normal() const { return p.cross(q); }
};

/// The ellipse that covers the same directions as a light does, seen from a point outside. A body
/// between the point and the light lies before it, and what is behind it up to the light's outline
/// is the light itself.
Ellipse outline_ellipse(const DiscLight& light, const Vec3& point);
Ellipse outline_ellipse(const SphereLight& light, const Vec3& point);
Ellipse outline_ellipse(const EllipsoidLight& light, const Vec3& point);

/// A disc that covers the same directions as an ellipse does, seen from a point that is not in its
/// plane: a circular section of the cone over the ellipse (docs/theory/areas.md#curved-bodies). Its
/// size is any.
Disc circular_section(const Ellipse& ellipse, const Vec3& point);

/// Distance, in lengths of `direction`, at which a ray meets a light; of one that misses it to the
/// place nearest to it.
double entry_of(const DiscLight& light, const Vec3& origin, const Vec3& direction);
double entry_of(const EllipsoidLight& light, const Vec3& origin, const Vec3& direction);

} // namespace keiko
