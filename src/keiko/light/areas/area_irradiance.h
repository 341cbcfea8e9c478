#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/light/luminance/projected_solid_angle.h"

#include <vector>

namespace keiko {

/// Unit vector along the longest side of a panel, the first of several.
Vec3 longest_side(const PolygonLight& light);

/// Corners of a convex body around a light and the lines across it that visibility is queried for.
/// It is the rectangle around a panel along its longest side. Lines across a round outline are all
/// as long as the longest, and so reach beyond it: bodies around discs and ellipsoids hold their
/// ends. A sphere has the cube around it, beyond which unlit ends of lines reach.
std::vector<Vec3> bounds_of(const PolygonLight& light);
std::vector<Vec3> bounds_of(const SphereLight& light);
std::vector<Vec3> bounds_of(const DiscLight& light);
std::vector<Vec3> bounds_of(const FrustumLight& light);
std::vector<Vec3> bounds_of(const EllipsoidLight& light);
std::vector<Vec3> bounds_of(const ContourLight& light);

/// A sphere around a light, of any luminance.
SphereLight sphere_around(const DiscLight& light);
SphereLight sphere_around(const FrustumLight& light);
SphereLight sphere_around(const EllipsoidLight& light);
SphereLight sphere_around(const ContourLight& light);

/// Lower bound, radians, of the angles between a unit direction and the ways from a point to a
/// light: that of a sphere around the light; 0 within it.
double least_angle(const PolygonLight& light, const Vec3& point, const Vec3& direction);
double least_angle(const SphereLight& light, const Vec3& point, const Vec3& direction);
template <class Light>
requires CurvedLight<Light> || std::same_as<Light, ContourLight>
double least_angle(const Light& light, const Vec3& point, const Vec3& direction) {
    return least_angle(sphere_around(light), point, direction);
}

/// The disc that covers the same directions as a sphere does, seen from a point outside: the rim is
/// the sphere's outline. Its normal points away from the point.
Disc outline_of(const SphereLight& sphere, const Vec3& point);

/// Projected solid angle in sr, 0 to pi, of the part of a panel above the horizon of `point` with
/// unit `normal`, in closed form (docs/theory/areas.md). 0 from behind a panel with one face.
double projected_solid_angle(const PolygonLight& light, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of the part of a sphere above the horizon of `point` with
/// unit `normal`, in closed form (docs/theory/areas.md). 0 inside of it.
double projected_solid_angle(const SphereLight& light, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of the part of a disc that is above the horizon of `point`
/// with unit `normal`, in closed form. 0 from behind it.
double projected_solid_angle(const DiscLight& light, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of the part of a lateral surface that faces the point
/// above its horizon, in closed form along the contour (docs/theory/areas.md#curved-bodies).
double projected_solid_angle(const FrustumLight& light, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of the part of an ellipsoid above the horizon of `point`
/// with unit `normal`, in closed form (docs/theory/areas.md#curved-bodies). 0 inside of it.
double projected_solid_angle(const EllipsoidLight& light, const Vec3& point, const Vec3& normal);

/// Projected solid angle in sr, 0 to pi, of what is visible of a luminous body above the horizon
/// of `point` with unit `normal`, to the relative `error`. By lines across its outline
/// (docs/theory/areas.md#bodies-by-their-contour); 0 inside of it.
double projected_solid_angle(const ContourLight& light, const Vec3& point, const Vec3& normal,
                             double error = 1e-6);

/// True if a point lies on a panel, where its light is undefined.
bool holds(const PolygonLight& light, const Vec3& point);
/// True if a point lies inside of a sphere. The surface itself is outside.
bool holds(const SphereLight& light, const Vec3& point);
/// True if a point lies on a disc.
bool holds(const DiscLight& light, const Vec3& point);
/// True if a point lies within a lateral surface, between its ends. The surface itself is outside.
bool holds(const FrustumLight& light, const Vec3& point);
/// True if a point lies inside of an ellipsoid. The surface itself is outside.
bool holds(const EllipsoidLight& light, const Vec3& point);
/// True if a point lies inside of a luminous body.
bool holds(const ContourLight& light, const Vec3& point);

} // namespace keiko
