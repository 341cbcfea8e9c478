#include "keiko/light/areas/area_irradiance.h"

#include "keiko/math/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Distance from a source, as a share of its size, within which points count as on it.
constexpr double rounding = 1e-9;

/// Winding number of a polygon's boundary about a point of its plane, in turns.
double windings(const PolygonLight& light, const Vec3& point, const Vec3& normal) {
    double turned = 0;
    Vec3 from = light.corners.back() - point;
    for (const Vec3& corner : light.corners) {
        const Vec3 to = corner - point;
        turned += std::atan2(normal.dot(from.cross(to)), from.dot(to));
        from = to;
    }
    return turned / (2 * std::numbers::pi);
}

} // namespace

Vec3 longest_side(const PolygonLight& light) {
    Vec3 longest(0), from = light.corners.back();
    for (const Vec3& corner : light.corners) {
        if ((corner - from).length2() > longest.length2()) longest = corner - from;
        from = corner;
    }
    return longest.normalized();
}

std::vector<Vec3> bounds_of(const PolygonLight& light) {
    const Vec3 along = longest_side(light), across = light.normal().cross(along);
    const Vec3& first = light.corners.front();
    Vec2 low(0), high(0);
    for (const Vec3& corner : light.corners) {
        const Vec2 at(along.dot(corner - first), across.dot(corner - first));
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    std::vector<Vec3> corners;
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y}) corners.push_back(first + along * x + across * y);
    return corners;
}

std::vector<Vec3> bounds_of(const SphereLight& light) {
    std::vector<Vec3> corners;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1})
            for (const double z : {-1, 1})
                corners.push_back(light.center + Vec3(x, y, z) * light.radius);
    return corners;
}

double least_angle(const PolygonLight& light, const Vec3& point, const Vec3& direction) {
    Box3 box;
    for (const Vec3& corner : light.corners) box.extend(corner);
    SphereLight around{(box.lower + box.upper) / 2, 0};
    for (const Vec3& corner : light.corners)
        around.radius = std::max(around.radius, (corner - around.center).length());
    return least_angle(around, point, direction);
}

double least_angle(const SphereLight& light, const Vec3& point, const Vec3& direction) {
    const Vec3 way = light.center - point;
    const double distance = way.length();
    if (!(distance > light.radius)) return 0;
    const double to_center = std::atan2(direction.cross(way).length(), direction.dot(way));
    return std::max(0.0, to_center - std::asin(light.radius / distance));
}

Disc outline_of(const SphereLight& sphere, const Vec3& point) {
    const Vec3 way = sphere.center - point;
    const double distance = way.length(), sine = sphere.radius / distance;
    return {sphere.center - way * (sine * sine), way / distance,
            sphere.radius * std::sqrt((1 - sine) * (1 + sine))};
}

double projected_solid_angle(const PolygonLight& light, const Vec3& point, const Vec3& normal) {
    return light.shines_at(point) ? projected_solid_angle(light.corners, point, normal) : 0;
}

double projected_solid_angle(const SphereLight& light, const Vec3& point, const Vec3& normal) {
    if (!((light.center - point).length() > light.radius)) return 0;
    return projected_solid_angle(outline_of(light, point), point, normal);
}

bool holds(const PolygonLight& light, const Vec3& point) {
    const Vec3 normal = polygon_normal(light.corners);
    const double size = std::sqrt(normal.length()), off = (point - light.corners[0]).dot(normal);
    return std::abs(off) <= rounding * size * normal.length() &&
           std::abs(windings(light, point, normal.normalized())) > 0.5;
}

bool holds(const SphereLight& light, const Vec3& point) {
    return (point - light.center).length() < light.radius * (1 - rounding);
}

} // namespace keiko
