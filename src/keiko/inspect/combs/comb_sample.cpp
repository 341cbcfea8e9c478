#include "keiko/inspect/combs/comb_sample.h"

#include "keiko/geometry/bezier/differential_geometry.h"

#include <cmath>

namespace keiko {

namespace {

Vec3 along(const SurfaceDerivatives& s, const Vec2& direction) {
    return s.du() * direction.x + s.dv() * direction.y;
}

Vec3 twice_along(const SurfaceDerivatives& s, const Vec2& direction) {
    return s.duu() * (direction.x * direction.x) + s.duv() * (2 * direction.x * direction.y) +
           s.dvv() * (direction.y * direction.y);
}

} // namespace

std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction) {
    const Vec3 tangent = along(s, direction);
    const double curvature = twice_along(s, direction).dot(outward) / tangent.dot(tangent);
    if (!std::isfinite(curvature)) return std::nullopt;
    return CurveBend{curvature, curvature, outward};
}

std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane) {
    constexpr double least_sine = 1e-6;
    const Vec3 in_plane = outward - plane * plane.dot(outward);
    const double sine = in_plane.length();
    if (!(sine > least_sine)) return std::nullopt;
    // Along the curve the plane's height is constant.
    const Vec2 level(plane.dot(s.dv()), -plane.dot(s.du()));
    auto bend = normal_bend(s, outward, level);
    if (!bend) return std::nullopt;
    bend->curvature /= sine;
    bend->towards = in_plane / sine;
    return bend;
}

std::optional<CurveBend> touching_bend(const SurfaceDerivatives& s, const Vec3& plane,
                                       const Vec2& direction, const Vec2& turning) {
    const Vec3 tangent = along(s, direction),
               second = twice_along(s, direction) + along(s, turning);
    const Vec3 left = plane.cross(tangent).normalized();
    const double curvature = second.dot(left) / tangent.dot(tangent);
    if (!std::isfinite(curvature)) return std::nullopt;
    return CurveBend{curvature, 0, left};
}

} // namespace keiko
