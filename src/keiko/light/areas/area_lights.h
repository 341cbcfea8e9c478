#pragma once

#include "keiko/base/export.h"
#include "keiko/light/areas/contour_light.h"
#include "keiko/light/areas/curved_lights.h"
#include "keiko/math/polygon.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <vector>

namespace KEIKO_API keiko {

/// A plane panel of uniform luminance in all directions: an LED panel, a light box, a screen.
struct PolygonLight {
    std::vector<Vec3> corners; ///< mm, at least 3 in a plane, convex or not, without crossings
    Rgb luminance{10000};      ///< cd/m2, colour included
    /// True if both faces shine; else only the one from which the corners run anticlockwise.
    bool two_sided = false;
    /// False if cameras and mirrors show it by a face of a body.
    bool shown = true;

    /// Unit normal of the face that shines.
    Vec3 normal() const { return polygon_normal(corners).normalized(); }
    /// True if the panel shows a point a face that shines.
    bool shines_at(const Vec3& point) const {
        return two_sided || normal().dot(point - corners.front()) > 0;
    }
    bool operator==(const PolygonLight&) const = default;
};

/// A globe of uniform luminance in all directions.
struct SphereLight {
    Vec3 center{0};       ///< mm
    double radius = 100;  ///< mm, > 0
    Rgb luminance{10000}; ///< cd/m2, colour included

    bool operator==(const SphereLight&) const = default;
};

/// Distance, in lengths of `direction`, at which a ray enters a sphere; of one that misses it to
/// the place nearest to it. The origin is outside.
inline double entry_of(const SphereLight& light, const Vec3& origin, const Vec3& direction) {
    const Vec3 way = light.center - origin;
    const double along = way.dot(direction), square = direction.length2();
    const double inside = along * along - square * (way.length2() - light.radius * light.radius);
    return (along - std::sqrt(std::max(inside, 0.0))) / square;
}

/// Lights with an area that are no tubes.
template <class Light>
concept AreaLight = std::same_as<Light, PolygonLight> || std::same_as<Light, SphereLight> ||
    CurvedLight<Light> || std::same_as<Light, ContourLight>;

/// Area lights that are shown by themselves, and not by a body of the scene.
template <class Light>
concept ShownLight = AreaLight<Light> && !std::same_as<Light, ContourLight>;

} // namespace keiko
