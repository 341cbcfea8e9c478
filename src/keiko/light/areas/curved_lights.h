#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <concepts>

namespace KEIKO_API keiko {

/// A flat round disc of uniform luminance whose one face shines: the end of a cylinder.
struct DiscLight {
    Vec3 center{0};        ///< mm
    Vec3 normal{0, 0, -1}; ///< unit, of the face that shines
    double radius = 100;   ///< mm, > 0
    Rgb luminance{10000};  ///< cd/m2, colour included

    /// True if the disc shows a point the face that shines.
    bool shines_at(const Vec3& point) const { return normal.dot(point - center) > 0; }
    bool operator==(const DiscLight&) const = default;
};

/// The lateral surface of a cylinder or of a cone, whole or truncated, that shines outwards. Its
/// ends are open.
struct FrustumLight {
    Vec3 from{0};           ///< mm, center of the first rim
    Vec3 to{0, 0, 1000};    ///< mm, center of the second rim, elsewhere
    double radius = 100;    ///< mm, of the first rim, from 0
    double to_radius = 100; ///< mm, of the second rim, from 0; not both are 0
    Rgb luminance{10000};   ///< cd/m2, colour included

    /// Unit vector from the first rim to the second.
    Vec3 along() const { return (to - from).normalized(); }
    bool operator==(const FrustumLight&) const = default;
};

/// An ellipsoid of uniform luminance: the affine image of a sphere.
struct EllipsoidLight {
    Vec3 center{0}; ///< mm
    /// mm, conjugate half-diameters: the images of the sphere's x, y and z; not in a plane.
    Vec3 u{100, 0, 0}, v{0, 100, 0}, w{0, 0, 100};
    Rgb luminance{10000}; ///< cd/m2, colour included

    /// A way of the scene in parts of the half-diameters: on the surface those to places from the
    /// center have the length 1.
    Vec3 in_sphere(const Vec3& way) const {
        const Vec3 vw = v.cross(w), wu = w.cross(u), uv = u.cross(v);
        return Vec3(vw.dot(way), wu.dot(way), uv.dot(way)) / vw.dot(u);
    }
    /// True if it shows a point its surface: outside.
    bool shines_at(const Vec3& point) const { return in_sphere(point - center).length() > 1; }
    bool operator==(const EllipsoidLight&) const = default;
};

/// Lights with curved outlines that are no tubes and no spheres.
template <class Light>
concept CurvedLight = std::same_as<Light, DiscLight> || std::same_as<Light, FrustumLight> ||
    std::same_as<Light, EllipsoidLight>;

} // namespace keiko
