#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/ellipse.h"
#include "keiko/light/areas/frustum_view.h"
#include "keiko/math/convex_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace keiko {
namespace {

template <class Light>
std::optional<AreaHit> hit_in_ellipse(const Light& light, const Vec3& origin, const Vec3& direction,
                                      const std::optional<RayDifferentials>& spread) {
    const Ellipse outline = outline_ellipse(light, origin);
    const PlaneAxes plane(outline.center, outline.normal().normalized());
    auto foot = footprint_on(plane, origin, direction, spread);
    if (!foot) return std::nullopt;
    const Vec2 p = plane.place(outline.center + outline.p);
    const Vec2 q = plane.place(outline.center + outline.q);
    const auto in_circle = [&, area = p.cross(q)](const Vec2& at) {
        return Vec2(at.cross(q) / area, p.cross(at) / area);
    };
    foot->hit = in_circle(foot->hit), foot->dx = in_circle(foot->dx),
    foot->dy = in_circle(foot->dy);
    const double share = share_in_circle(*foot, 1);
    if (!(share > 0)) return std::nullopt;
    return hit_of(entry_of(light, origin, direction), share);
}

/// Distance, in lengths of `direction`, at which a ray enters a lateral surface; nullopt for one
/// that misses it. `view` is that of the ray's origin.
std::optional<double> entry_of(const FrustumView& view, const Vec3& direction) {
    const double length = view.along.dot(view.to - view.from);
    const double slope = (view.to_radius - view.radius) / length;
    const double z = -view.along.dot(view.from), dz = view.along.dot(direction);
    const Vec3 off = -view.from - view.along * z, across = direction - view.along * dz;
    const double r = view.radius + slope * z, dr = slope * dz;
    // |off + t across|^2 = (r + t dr)^2
    const double a = across.length2() - dr * dr, half = off.dot(across) - r * dr;
    const double c = off.length2() - r * r, root = half * half - a * c;
    if (!(root >= 0)) return std::nullopt;
    const double both = -half - std::copysign(std::sqrt(root), half);
    std::optional<double> entry;
    for (const double t : {both / a, c / both}) {
        const double share = (z + t * dz) / length;
        const bool enters = (off + across * t).dot(across) < (r + t * dr) * dr;
        if (t > 0 && share >= 0 && share <= 1 && enters && r + t * dr >= 0)
            entry = std::min(entry.value_or(t), t);
    }
    return entry;
}

/// Depth, mm along a unit direction from the point, of the place of the axis nearest to that ray:
/// about that of the outline there.
double depth_beside(const FrustumView& view, const Vec3& ahead) {
    const Vec3 axis = view.to - view.from;
    const Vec3 from = square_to(view.from, ahead), across = square_to(axis, ahead);
    const double length2 = across.length2();
    const double share = length2 > 0 ? std::clamp(-from.dot(across) / length2, 0.0, 1.0) : 0.5;
    return ahead.dot(view.from + axis * share);
}

/// The outline of the visible part, in chords of its rims with at most this error, mm.
std::vector<Vec3> outline_of(const FrustumView& view, double error) {
    constexpr double most = 256, least = 8;
    std::vector<Vec3> corners;
    const auto add_rim = [&](double radius, double sign, const auto& at) {
        const double step = 2 * std::sqrt(2 * error / std::max(radius, error));
        const double chords = std::clamp(std::ceil(2 * view.half / step), least, most);
        for (double i = 0; i <= chords; ++i)
            corners.push_back(at(sign * view.half * (2 * i / chords - 1)));
    };
    add_rim(view.radius, 1, [&](double angle) { return view.on_rim(angle); });
    add_rim(view.to_radius, -1, [&](double angle) { return view.on_to_rim(angle); });
    return corners;
}

/// Central projection of what is before the point to a plane at a distance across a direction.
std::vector<Vec2> projected(const std::vector<Vec3>& corners, const PlaneAxes& plane,
                            const Vec3& ahead, double distance) {
    constexpr double beside = 1e-3; // of the way to it: what is no more ahead is no neighbour
    std::vector<Vec2> places;
    clip_convex(
        corners, [&](std::size_t i) { return ahead.dot(corners[i]) - beside * distance; },
        [&](const Vec3& corner) {
            const Vec3 at = corner * (distance / ahead.dot(corner));
            places.emplace_back(plane.x.dot(at), plane.y.dot(at));
        });
    return places;
}

/// Depth, mm along a unit direction from the point, of the place of an outline before the point
/// that is nearest to that ray; nullopt without any.
std::optional<double> depth_of_nearest(const std::vector<Vec3>& outline, const Vec3& ahead) {
    std::optional<double> depth;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const double to_a = ahead.dot(a), to_b = ahead.dot(b);
        if (!(to_a > 0 && to_b > 0)) continue;
        const Vec3 from = a / to_a - ahead, side = b / to_b - ahead - from;
        const double length2 = side.length2();
        const double share = length2 > 0 ? std::clamp(-from.dot(side) / length2, 0.0, 1.0) : 0.0;
        const double off = (from + side * share).length2();
        if (!(off < least)) continue;
        least = off;
        depth = 1 / ((1 - share) / to_a + share / to_b);
    }
    return depth;
}

} // namespace

std::optional<AreaHit> area_hit(const DiscLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!light.shines_at(origin)) return std::nullopt;
    return hit_in_ellipse(light, origin, direction, spread);
}

std::optional<AreaHit> area_hit(const SphereLight& light, const Vec3& origin, const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!((light.center - origin).length() > light.radius)) return std::nullopt;
    return hit_in_ellipse(light, origin, direction, spread);
}

std::optional<AreaHit> area_hit(const EllipsoidLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!light.shines_at(origin)) return std::nullopt;
    return hit_in_ellipse(light, origin, direction, spread);
}

std::optional<AreaHit> area_hit(const FrustumLight& light, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    const auto view = FrustumView::of(light, origin);
    if (!view) return std::nullopt;
    const std::optional<double> entry = entry_of(*view, direction);
    if (entry && !spread) return hit_of(*entry, 1);
    const SphereLight around = sphere_around(light);
    const Vec3 ahead = direction.normalized();
    const double depth = entry ? *entry * direction.length() : depth_beside(*view, ahead);
    if (!(depth > 0)) return std::nullopt;
    const double t = depth / direction.length();
    const PlaneAxes plane(origin + ahead * depth, ahead);
    const auto foot = footprint_on(plane, origin, direction, spread);
    if (!foot) return std::nullopt;
    if (foot->area() == 0) return hit_of(t, entry ? 1 : 0);
    constexpr double of_pixel = 0.002;
    const double off = square_to(around.center - origin, ahead).length();
    if (!entry && off > around.radius + foot->reach()) return std::nullopt;
    const std::vector<Vec3> outline = outline_of(*view, of_pixel * foot->reach());
    const double share = share_in_polygon(*foot, projected(outline, plane, ahead, depth));
    if (entry) return hit_of(t, share);
    // Beside the surface its edge is what the pixel holds of it, as another face does there.
    return hit_of(depth_of_nearest(outline, ahead).value_or(depth) / direction.length(), share);
}

} // namespace keiko
