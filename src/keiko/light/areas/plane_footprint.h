#pragma once

#include "keiko/math/ray_differentials.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <array>
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

/// Footprint of a pixel on a plane, in the plane's frame: a parallelogram.
struct PlaneFootprint {
    double t = 0;      ///< of the centre's ray
    Vec2 hit{0};       ///< of the centre's ray
    Vec2 dx{0}, dy{0}; ///< change of the hit by the pixel

    /// Area of the parallelogram, signed.
    double area() const { return dx.cross(dy); }
    /// Largest distance of a place of it from the hit.
    double reach() const { return std::max((dx + dy).length(), (dx - dy).length()) / 2; }
    /// Corners, from the hit.
    std::array<Vec2, 4> corners() const {
        const Vec2 right = dx / 2, up = dy / 2;
        return {right * -1 - up, right - up, right + up, up - right};
    }
};

/// Footprint of the rays of a pixel around a ray, or of the ray alone without a `spread`. nullopt
/// for a ray away from the plane or along it.
std::optional<PlaneFootprint> footprint_on(const PlaneAxes& plane, const Vec3& origin,
                                           const Vec3& direction,
                                           const std::optional<RayDifferentials>& spread);

/// Hit of a light that fills a share of a footprint; nullopt if it fills none.
std::optional<AreaHit> hit_of(double t, double coverage);
/// Share, 0 to 1, of a footprint in a polygon of its plane, convex or not.
double share_in_polygon(const PlaneFootprint& foot, const std::vector<Vec2>& polygon);
/// Share, 0 to 1, of a footprint in a circle about 0 of its plane.
double share_in_circle(const PlaneFootprint& foot, double radius);

} // namespace keiko
