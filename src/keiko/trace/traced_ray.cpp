#include "keiko/trace/traced_ray.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::optional<TracedRay> traced_ray(const Ray& ray, const Vec3& center, double radius) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double speed = ray.direction.length();
    if (!is_finite(ray.origin) || !(speed > 0 && std::isfinite(speed))) return std::nullopt;
    const Vec3 direction = ray.direction / speed;
    const Vec3 to_center = center - ray.origin;
    const double foot = to_center.dot(direction), away = to_center.length();
    const Vec3 off = to_center - direction * foot;
    // Far origins blur the ball's border: whatever may touch it must come in.
    const double ball = radius * 1.001 + 64 * epsilon * away;
    const double half2 = ball * ball - off.dot(off);
    if (!(half2 >= 0)) return std::nullopt;
    const double half = std::sqrt(half2);

    TracedRay traced;
    traced.ray = &ray;
    traced.direction = direction;
    traced.speed = speed;
    // Not t_min: a hit's t must have the same last bit whatever range it is asked in.
    traced.t_start = away <= ball ? 0 : (foot - half) / speed;
    traced.start = ray.at(traced.t_start);
    traced.error = 2 * epsilon * (ray.origin.length() + std::abs(traced.t_start) * speed);
    traced.slack = 8 * epsilon * (away + ball);
    const double to_start = traced.t_start * speed;
    traced.low = std::max(ray.t_min * speed, foot - half) - to_start - traced.slack;
    traced.high = std::min(ray.t_max * speed, foot + half) - to_start + traced.slack;
    if (!(traced.low <= traced.high)) return std::nullopt;
    return traced;
}

} // namespace keiko
