#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/math/ray_differentials.h"

#include <optional>
#include <vector>

namespace keiko {

/// A light on a ray, or on the rays of a pixel.
struct AreaHit {
    double t = 0;        ///< distance of the light, in lengths of the ray's direction
    double coverage = 0; ///< share of the pixel's footprint that the light fills, above 0 to 1
};

/// Frame of a plane in space.
struct PlaneAxes {
    Vec3 origin{0};  ///< mm, a place in it
    Vec3 normal{0};  ///< unit
    Vec3 x{0}, y{0}; ///< unit, in it, at right angles to each other

    /// Frame with any x.
    PlaneAxes(const Vec3& through, const Vec3& unit_normal);
    /// Place of a point in it, mm.
    Vec2 place(const Vec3& at) const { return {x.dot(at - origin), y.dot(at - origin)}; }
};

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
/// Sphere on the rays of a pixel, by its outline as seen from the origin of the central ray.
std::optional<AreaHit> area_hit(const SphereLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread);

} // namespace keiko
