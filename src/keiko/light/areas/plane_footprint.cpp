#include "keiko/light/areas/plane_footprint.h"

#include "keiko/math/axes.h"
#include "keiko/math/convex_clip.h"
#include "keiko/math/polygon.h"

#include <cmath>
#include <utility>

namespace keiko {

PlaneAxes::PlaneAxes(const Vec3& through, const Vec3& unit_normal)
    : origin(through),
      normal(unit_normal),
      x(any_perpendicular(unit_normal).normalized()),
      y(unit_normal.cross(x)) {}

std::optional<PlaneFootprint> footprint_on(const PlaneAxes& plane, const Vec3& origin,
                                           const Vec3& direction,
                                           const std::optional<RayDifferentials>& spread) {
    const double approach = plane.normal.dot(direction);
    const double height = plane.normal.dot(plane.origin - origin);
    constexpr double parallel = 1e-12;
    if (!(std::abs(approach) > parallel * direction.length())) return std::nullopt;
    PlaneFootprint foot;
    foot.t = height / approach;
    if (!(foot.t > 0)) return std::nullopt;
    foot.hit = plane.place(origin + direction * foot.t);
    if (!spread) return foot;
    const auto change = [&](const Vec3& by_origin, const Vec3& by_direction) {
        const Vec3 off = by_origin + by_direction * foot.t;
        const Vec3 along = off - direction * (plane.normal.dot(off) / approach);
        return Vec2(plane.x.dot(along), plane.y.dot(along));
    };
    foot.dx = change(spread->origin_dx, spread->direction_dx);
    foot.dy = change(spread->origin_dy, spread->direction_dy);
    return foot;
}

namespace {

/// Area of the part of a polygon, given in parts of a parallelogram's sides from its centre, in the
/// parallelogram. Sides that clipping doubles cancel if the polygon is not convex.
double area_in_square(std::vector<Vec2> corners) {
    for (const Vec2& inward : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
        std::vector<Vec2> left;
        clip_convex(
            corners, [&](std::size_t i) { return 0.5 + inward.dot(corners[i]); },
            [&](const Vec2& corner) { left.push_back(corner); });
        corners = std::move(left);
    }
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += corners[i].cross(corners[(i + 1) % corners.size()]);
    return std::abs(twice) / 2;
}

/// Signed area between a side from a to b and the centre of a circle about 0, inside of it.
double area_in_circle(const Vec2& a, const Vec2& b, double radius) {
    const auto sector = [&](const Vec2& from, const Vec2& to) {
        return radius * radius / 2 * std::atan2(from.cross(to), from.dot(to));
    };
    const Vec2 way = b - a;
    const double length2 = way.dot(way), half = a.dot(way);
    const double root = half * half - length2 * (a.dot(a) - radius * radius);
    if (!(root > 0) || !(length2 > 0)) return sector(a, b);
    const double enter = (-half - std::sqrt(root)) / length2;
    const double leave = (-half + std::sqrt(root)) / length2;
    if (!(enter < 1) || !(leave > 0)) return sector(a, b);
    const Vec2 from = a + way * std::max(enter, 0.0), to = a + way * std::min(leave, 1.0);
    return (enter > 0 ? sector(a, from) : 0) + from.cross(to) / 2 + (leave < 1 ? sector(to, b) : 0);
}

} // namespace

std::optional<AreaHit> hit_of(double t, double coverage) {
    if (!(coverage > 0)) return std::nullopt;
    return AreaHit{t, std::min(coverage, 1.0)};
}

double share_in_polygon(const PlaneFootprint& foot, const std::vector<Vec2>& polygon) {
    const double area = foot.area();
    if (area == 0) return holds(polygon, foot.hit) ? 1 : 0;
    std::vector<Vec2> corners;
    for (const Vec2& corner : polygon) {
        const Vec2 off = corner - foot.hit;
        corners.emplace_back(off.cross(foot.dy) / area, foot.dx.cross(off) / area);
    }
    return area_in_square(std::move(corners));
}

double share_in_circle(const PlaneFootprint& foot, double radius) {
    const double area = foot.area(), off = foot.hit.length(), reach = foot.reach();
    if (area == 0) return off < radius ? 1 : 0;
    // Far from the rim the sectors of a small footprint are nothing but rounding.
    if (off > radius + reach) return 0;
    if (off < radius - reach) return 1;
    const std::array<Vec2, 4> corners = foot.corners();
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += area_in_circle(foot.hit + corners[i], foot.hit + corners[(i + 1) % 4], radius);
    return sum / area;
}

} // namespace keiko
