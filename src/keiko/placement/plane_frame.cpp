#include "keiko/placement/plane_frame.h"

namespace keiko {
namespace {

/// Cosine below which a ray counts as parallel to the plane.
constexpr double parallel = 1e-12;

} // namespace

PlaneFrame PlaneFrame::turned(double radians) const {
    const double c = std::cos(radians), s = std::sin(radians);
    return {origin, u * c + v * s, v * c - u * s};
}

PlaneFrame frame_of(const CPlane& plane) {
    return {plane.origin, plane.u.normalized(), plane.v.normalized()};
}

std::optional<PlaneHit> meet(const PlaneFrame& frame, const Ray& ray) {
    const Vec3 normal = frame.normal();
    const double approach = normal.dot(ray.direction);
    const double length = ray.direction.length();
    if (!(std::abs(approach) > parallel * length)) return {};
    const double t = -frame.height(ray.origin) / approach;
    if (!(t > 0)) return {};
    PlaneHit hit{.place = frame.place(ray.at(t)),
                 .t = t,
                 .cosine = std::abs(approach) / length,
                 .gradients = {}};
    if (!ray.differentials) return hit;

    const auto moved = [&](const Vec3& origin_change, const Vec3& direction_change) {
        const Vec3 drift = origin_change + direction_change * t;
        return drift - ray.direction * (normal.dot(drift) / approach);
    };
    const RayDifferentials& d = *ray.differentials;
    const Vec3 dx = moved(d.origin_dx, d.direction_dx), dy = moved(d.origin_dy, d.direction_dy);
    hit.gradients = {.u = {dx.dot(frame.u), dy.dot(frame.u)},
                     .v = {dx.dot(frame.v), dy.dot(frame.v)}};
    return hit;
}

std::optional<Vec2> crossing(const PlaneFrame& frame, const Vec3& a, const Vec3& b) {
    const double above = frame.height(a), below = frame.height(b);
    if (!(above * below < 0)) return {};
    return frame.place(a + (b - a) * (above / (above - below)));
}

} // namespace keiko
