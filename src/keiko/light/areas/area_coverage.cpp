#include "keiko/light/areas/area_coverage.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/math/axes.h"
#include "keiko/math/convex_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Footprint of a pixel on a plane, in a frame of the plane about the centre's hit.
struct PlaneFootprint {
    double t = 0; ///< of the centre's ray
    Vec3 hit{0}, x{0}, y{0};
    Vec2 dx{0}, dy{0}; ///< change of the hit by the pixel

    Vec2 place(const Vec3& at) const { return {x.dot(at - hit), y.dot(at - hit)}; }
    /// Area of the parallelogram, signed.
    double area() const { return dx.cross(dy); }
    std::array<Vec2, 4> corners() const {
        const Vec2 right = dx / 2, up = dy / 2;
        return {right * -1 - up, right - up, right + up, up - right};
    }
};

/// nullopt for a ray away from the plane or along it.
std::optional<PlaneFootprint> footprint_on(const Vec3& through, const Vec3& normal,
                                           const Vec3& origin, const Vec3& direction,
                                           const std::optional<RayDifferentials>& spread) {
    const double approach = normal.dot(direction), height = normal.dot(through - origin);
    constexpr double parallel = 1e-12;
    if (!(std::abs(approach) > parallel * direction.length())) return std::nullopt;
    PlaneFootprint foot;
    foot.t = height / approach;
    if (!(foot.t > 0)) return std::nullopt;
    foot.hit = origin + direction * foot.t;
    foot.x = any_perpendicular(normal).normalized();
    foot.y = normal.cross(foot.x);
    if (!spread) return foot;
    const auto change = [&](const Vec3& by_origin, const Vec3& by_direction) {
        const Vec3 off = by_origin + by_direction * foot.t;
        const Vec3 along = off - direction * (normal.dot(off) / approach);
        return Vec2(foot.x.dot(along), foot.y.dot(along));
    };
    foot.dx = change(spread->origin_dx, spread->direction_dx);
    foot.dy = change(spread->origin_dy, spread->direction_dy);
    return foot;
}

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

/// Even-odd rule for the place 0.
bool holds_zero(std::span<const Vec2> corners) {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y > 0) != (b.y > 0) && a.x - (b.x - a.x) * (a.y / (b.y - a.y)) > 0) inside = !inside;
    }
    return inside;
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

std::optional<AreaHit> hit_of(double t, double coverage) {
    if (!(coverage > 0)) return std::nullopt;
    return AreaHit{t, std::min(coverage, 1.0)};
}

} // namespace

std::optional<AreaHit> area_hit(const PolygonLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!light.shines_at(origin)) return std::nullopt;
    const auto foot =
        footprint_on(light.corners.front(), light.normal(), origin, direction, spread);
    if (!foot) return std::nullopt;
    std::vector<Vec2> corners;
    for (const Vec3& corner : light.corners) corners.push_back(foot->place(corner));
    const double area = foot->area();
    if (area == 0) return hit_of(foot->t, holds_zero(corners) ? 1 : 0);
    for (Vec2& corner : corners)
        corner = {corner.cross(foot->dy) / area, foot->dx.cross(corner) / area};
    return hit_of(foot->t, area_in_square(std::move(corners)));
}

std::optional<AreaHit> area_hit(const SphereLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!((light.center - origin).length() > light.radius)) return std::nullopt;
    const Disc outline = outline_of(light, origin);
    const auto foot = footprint_on(outline.center, outline.normal, origin, direction, spread);
    if (!foot) return std::nullopt;
    const double t = entry_of(light, origin, direction);
    const Vec2 center = foot->place(outline.center);
    const double area = foot->area();
    if (area == 0) return hit_of(t, center.length() < outline.radius ? 1 : 0);
    const std::array<Vec2, 4> corners = foot->corners();
    // Far from the rim the sectors of a small footprint are nothing but rounding.
    const double reach = std::max(corners[0].length(), corners[1].length());
    if (center.length() > outline.radius + reach) return std::nullopt;
    if (center.length() < outline.radius - reach) return AreaHit{t, 1};
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += area_in_circle(corners[i] - center, corners[(i + 1) % 4] - center, outline.radius);
    return hit_of(t, sum / area);
}

} // namespace keiko
