#pragma once

#include "keiko/geometry/bezier/ray.h"
#include "keiko/intersect/roots/planar_net.h"
#include "keiko/intersect/subpatch/sub_patch.h"

namespace keiko {

/// A ray in the coordinates of a part, made ready for its sub-patches.
struct PartRay {
    Vec3 origin{0};
    Vec3 direction{0};             ///< unit
    Vec3 normal_f{0}, normal_g{0}; ///< of the two planes through the ray; unit, orthogonal
    double speed = 1;              ///< mm of the part in one unit of the world ray's t
    double error = 0;              ///< mm, bound of the distance to the exact ray at the origin
    double turn = 0; ///< radians, bound of the direction's error beyond that of being unit
};

/// `error`: by how much the given origin may miss the exact ray, mm.
PartRay part_ray(const Vec3& origin, const Vec3& direction, double error);

/// A sub-patch as a part ray sees it.
struct RayProjection {
    PlanarNet net;
    double slack; ///< bound of the error of a coefficient of `net`
    double
        foot; ///< mm along the ray from its origin to the place nearest to the sub-patch's centre
};

/// False when the ray stays clear of the ball around the sub-patch.
bool near_sub_patch(const PartRay& ray, const SubPatch& sub_patch);

RayProjection project_ray(const PartRay& ray, const SubPatch& sub_patch,
                          const BezierPatchView& points);

} // namespace keiko
