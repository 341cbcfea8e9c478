#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/math/ray_differentials.h"

#include <optional>

namespace keiko {

/// A light on a ray, or on the rays of a pixel.
struct AreaHit {
    double t = 0;        ///< distance of the light, in lengths of the ray's direction
    double coverage = 0; ///< share of the pixel's footprint that the light fills, above 0 to 1
};

/// Panel on the rays of a pixel around a ray, or on the ray alone without a `spread`. The pixel's
/// footprint on the panel's plane is a parallelogram. Its part on the panel is in closed form
/// (docs/theory/areas.md#in-mirrors-and-before-the-camera). nullopt for rays that miss the panel,
/// and for those that meet a dark face of it.
std::optional<AreaHit> area_hit(const PolygonLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);
/// Sphere on the rays of a pixel, by its outline as seen from the origin of the central ray.
std::optional<AreaHit> area_hit(const SphereLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);

} // namespace keiko
