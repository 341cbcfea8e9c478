#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/ellipse.h"
#include "keiko/light/areas/frustum_view.h"
#include "keiko/light/luminance/clipped_boundary.h"
#include "keiko/light/luminance/rim.h"
#include "keiko/math/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Distance from a source, as a share of its size, within which points count as on it.
constexpr double rounding = 1e-9;

Disc disc_of(const DiscLight& light) {
    return {light.center, light.normal, light.radius};
}

/// Stokes' integral along the contour of the visible part: a rim, a generator, the other rim back,
/// the other generator.
double along_contour(const FrustumView& view, const Vec3& normal) {
    const Rim rim({view.from, view.along, view.radius}, Vec3(0), normal);
    const Rim to_rim({view.to, view.along, view.to_radius}, Vec3(0), normal);
    // The side of a rim away from the point is at an angle near 0.
    const double first = rim.angle_of(-view.nearest) + std::numbers::pi;
    const double second = to_rim.angle_of(-view.nearest) + std::numbers::pi;
    ClippedBoundary boundary(normal);
    boundary.add_rim(rim, first - view.half, first + view.half);
    boundary.add_edge(view.on_rim(view.half), view.on_to_rim(view.half));
    boundary.add_rim(to_rim, second + view.half, second - view.half);
    boundary.add_edge(view.on_to_rim(-view.half), view.on_rim(-view.half));
    return std::abs(boundary.closed());
}

} // namespace

std::vector<Vec3> bounds_of(const DiscLight& light) {
    const Ellipse rim = outline_ellipse(light, Vec3(0));
    std::vector<Vec3> corners;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1})
            corners.push_back(rim.center + (rim.p * x + rim.q * y) * std::numbers::sqrt2);
    return corners;
}

std::vector<Vec3> bounds_of(const FrustumLight& light) {
    std::vector<Vec3> corners = bounds_of(DiscLight{light.from, light.along(), light.radius});
    const std::vector<Vec3> others = bounds_of(DiscLight{light.to, light.along(), light.to_radius});
    corners.insert(corners.end(), others.begin(), others.end());
    return corners;
}

std::vector<Vec3> bounds_of(const EllipsoidLight& light) {
    // A line's end is no farther from the centre than the half-diameters of the outline together.
    const double reach = std::sqrt(light.u.length2() + light.v.length2() + light.w.length2());
    return bounds_of(SphereLight{light.center, reach});
}

SphereLight sphere_around(const DiscLight& light) {
    return {light.center, light.radius};
}

SphereLight sphere_around(const FrustumLight& light) {
    const Vec3 half = (light.to - light.from) / 2;
    return {light.from + half, std::hypot(half.length(), std::max(light.radius, light.to_radius))};
}

SphereLight sphere_around(const EllipsoidLight& light) {
    return {light.center, std::sqrt(light.u.length2() + light.v.length2() + light.w.length2())};
}

double projected_solid_angle(const DiscLight& light, const Vec3& point, const Vec3& normal) {
    return light.shines_at(point) ? projected_solid_angle(disc_of(light), point, normal) : 0;
}

double projected_solid_angle(const FrustumLight& light, const Vec3& point, const Vec3& normal) {
    const auto view = FrustumView::of(light, point);
    if (!view) return 0;
    if (!view->all_around()) return along_contour(*view, normal);
    const auto within = [&](const Vec3& center, double radius) {
        return projected_solid_angle(Disc{center, view->along, radius}, Vec3(0), normal);
    };
    return std::abs(within(view->from, view->radius) - within(view->to, view->to_radius));
}

double projected_solid_angle(const EllipsoidLight& light, const Vec3& point, const Vec3& normal) {
    if (!light.shines_at(point)) return 0;
    return projected_solid_angle(circular_section(outline_ellipse(light, point), point), point,
                                 normal);
}

bool holds(const DiscLight& light, const Vec3& point) {
    const Vec3 off = point - light.center;
    return std::abs(light.normal.dot(off)) <= rounding * light.radius &&
           off.length() < light.radius;
}

bool holds(const FrustumLight& light, const Vec3& point) {
    const Vec3 way = light.to - light.from, off = point - light.from;
    const double share = way.dot(off) / way.length2();
    const double radius = light.radius + (light.to_radius - light.radius) * share;
    return share > 0 && share < 1 && (off - way * share).length() < radius * (1 - rounding);
}

bool holds(const EllipsoidLight& light, const Vec3& point) {
    return light.in_sphere(point - light.center).length() < 1 - rounding;
}

} // namespace keiko
