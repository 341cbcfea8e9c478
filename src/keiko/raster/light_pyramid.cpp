#include "keiko/raster/light_pyramid.h"

#include "keiko/math/convex_clip.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Half the thickness of the plane between a line and a light, in roundings: a triangle that begins
/// at the line leaves it before it rises by a rounding, unless it is as steep.
constexpr double thinness = 1e-3;

} // namespace

LightPyramid::LightPyramid(std::span<const Vec3> receiver, const Viewpoint& light,
                           double rounding) {
    if (receiver.size() == 2)
        add_line(receiver, light, rounding);
    else
        add_triangle(receiver, light, rounding);
    for (const Plane& side : sides_) lights_ &= is_finite(side.normal);
    for (const Plane& bound : bounds_) lights_ &= bound.normal != Vec3(0);
}

void LightPyramid::add_line(std::span<const Vec3> receiver, const Viewpoint& light,
                            double rounding) {
    const Vec3 &a = receiver[0], &b = receiver[1];
    const Vec3 across = light.way_to(a).cross(b - a).normalized();
    const double half = thinness * rounding;
    add(across, a, half), add(-across, a, half);
    const Vec3 up = across.cross(b - a).normalized();
    add(up.dot(light.way_to(a)) < 0 ? up : -up, a, -rounding);
    add_side(across.cross(light.way_to(b)), b, a);
    add_side(across.cross(light.way_to(a)), a, b);
}

void LightPyramid::add_triangle(std::span<const Vec3> receiver, const Viewpoint& light,
                                double rounding) {
    const Vec3 normal = (receiver[1] - receiver[0]).cross(receiver[2] - receiver[0]).normalized();
    // Along the light: at a flat angle, what stands so high on the receiver has a long shadow.
    double height = rounding;
    for (const Vec3& corner : receiver)
        height =
            std::min(height, rounding * std::abs(normal.dot(light.way_to(corner).normalized())));
    add(normal.dot(light.way_to(receiver[0])) < 0 ? normal : -normal, receiver[0], -height);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = receiver[(i + 1) % 3], &to = receiver[(i + 2) % 3];
        add_side(light.way_to(from).cross(to - from), from, receiver[i]);
    }
}

void LightPyramid::add(const Vec3& normal, const Vec3& point, double outwards) {
    bounds_.push_back({normal, outwards - normal.dot(point)});
}

void LightPyramid::add_side(const Vec3& normal, const Vec3& on, const Vec3& corner) {
    const Vec3 scaled = normal / normal.dot(corner - on);
    sides_.push_back({scaled, -scaled.dot(on)});
}

bool LightPyramid::Plane::misses(const Box3& box) const {
    const Vec3 middle = box.center(), half = box.extent() / 2;
    return at(middle) + magnitudes(normal).dot(half) < 0;
}

bool LightPyramid::meets(const Box3& box) const {
    for (const Plane& plane : bounds_)
        if (plane.misses(box)) return false;
    for (const Plane& plane : sides_)
        if (plane.misses(box)) return false;
    return true;
}

std::vector<Vec3> LightPyramid::shadow_of(const std::array<Vec3, 3>& triangle) const {
    std::vector<Vec3> part(triangle.begin(), triangle.end());
    const auto clip = [&](const Plane& plane) {
        std::vector<Vec3> kept;
        clip_convex(
            part, [&](std::size_t i) { return plane.at(part[i]); },
            [&](const Vec3& corner) { kept.push_back(corner); });
        part = std::move(kept);
    };
    for (const Plane& plane : bounds_) clip(plane);
    for (const Plane& plane : sides_) clip(plane);
    for (Vec3& corner : part) {
        Vec3 shares(0);
        for (unsigned i = 0; i < sides_.size(); ++i) shares[i] = sides_[i].at(corner);
        corner = shares / (shares.x + shares.y + shares.z);
    }
    return part;
}

} // namespace keiko
