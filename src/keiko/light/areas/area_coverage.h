#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/light/areas/plane_footprint.h"
#include "keiko/math/ray_differentials.h"

#include <optional>
#include <vector>

namespace keiko {

/// A panel in its plane, prepared for many rays.
struct PanelOutline {
    PlaneAxes plane;           ///< its normal is that of the face that shines
    bool two_sided;            ///< see PolygonLight
    std::vector<Vec2> corners; ///< mm, in the plane
    Vec2 middle;               ///< mm, of a circle around the corners
    double reach = 0;          ///< mm, radius of that circle

    explicit PanelOutline(const PolygonLight& light);
};

/// Panel on the rays of a pixel around a ray, or on the ray alone without a `spread`. The pixel's
/// footprint on the panel's plane is a parallelogram. Its part on the panel is in closed form
/// (docs/theory/areas.md#in-mirrors-and-before-the-camera). nullopt for rays that miss the panel,
/// and for those that meet a dark face of it.
std::optional<AreaHit> area_hit(const PanelOutline& panel, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);
/// Disc, sphere or ellipsoid on the rays of a pixel, by its outline as seen from the origin of the
/// central ray, in closed form.
std::optional<AreaHit> area_hit(const DiscLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);
std::optional<AreaHit> area_hit(const SphereLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);
std::optional<AreaHit> area_hit(const EllipsoidLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);
/// Lateral surface on the rays of a pixel, by its outline as seen from the origin of the central
/// ray. Rims are polygons with an error of at most 1/500 of the pixel, or of 256 chords.
std::optional<AreaHit> area_hit(const FrustumLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);

} // namespace keiko
