#include "keiko/inspect/comb_sample.h"

#include "keiko/patch/differential_geometry.h"

#include <cmath>

namespace keiko {

std::optional<CurveBend> normal_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                     const Vec2& direction) {
    const Vec3 tangent = s.du() * direction.x + s.dv() * direction.y;
    const Vec3 second = s.duu() * (direction.x * direction.x) +
                        s.duv() * (2 * direction.x * direction.y) +
                        s.dvv() * (direction.y * direction.y);
    const double curvature = second.dot(outward) / tangent.dot(tangent);
    if (!std::isfinite(curvature)) return std::nullopt;
    return CurveBend{curvature, curvature, outward};
}

std::optional<CurveBend> section_bend(const SurfaceDerivatives& s, const Vec3& outward,
                                      const Vec3& plane) {
    constexpr double least_sine = 1e-6;
    const Vec3 in_plane = outward - plane * plane.dot(outward);
    const double sine = in_plane.length();
    if (!(sine > least_sine)) return std::nullopt;
    // Along the curve the plane's height does not change.
    const Vec2 along(plane.dot(s.dv()), -plane.dot(s.du()));
    auto bend = normal_bend(s, outward, along);
    if (!bend) return std::nullopt;
    bend->curvature /= sine;
    bend->towards = in_plane / sine;
    return bend;
}

} // namespace keiko
