#include "keiko/placement/plane_frame.h"

#include <algorithm>
#include <cmath>

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

namespace {

constexpr double rounding = 1e-9; ///< of a unit vector, and of a length

bool lies_along(const Vec3& direction, const MirrorPlane& mirror) {
    return std::abs(direction[mirror.axis]) < rounding;
}
bool is_square_to(const Vec3& direction, const MirrorPlane& mirror) {
    return std::abs(std::abs(direction[mirror.axis]) - 1) < rounding;
}

} // namespace

bool is_own_image(const PlaneFrame& frame, const MirrorPlane& mirror) {
    return (is_square_to(frame.u, mirror) && lies_along(frame.v, mirror)) ||
           (is_square_to(frame.v, mirror) && lies_along(frame.u, mirror));
}

PlaneFrame image_of(const PlaneFrame& frame, const MirrorPlane& mirror) {
    return {mirror.image(frame.origin), mirror.image_of_direction(frame.u),
            mirror.image_of_direction(frame.v)};
}

Box2 symmetric_extent(const PlaneFrame& frame, const Box2& extent, const MirrorPlane& mirror) {
    const int across = is_square_to(frame.u, mirror) ? 0 : 1;
    const Vec3& direction = across == 0 ? frame.u : frame.v;
    const double middle = -mirror.distance(frame.origin) / direction[mirror.axis];
    const double half =
        std::max(std::abs(extent.lower[across] - middle), std::abs(extent.upper[across] - middle));
    Box2 symmetric = extent;
    symmetric.lower[across] = middle - half, symmetric.upper[across] = middle + half;
    return symmetric;
}

bool is_own_image(const Camera& camera, const MirrorPlane& mirror) {
    const CameraAxes axes = camera.axes();
    const double distance = (camera.target - camera.eye).length();
    return std::abs(mirror.distance(camera.eye)) < rounding * distance &&
           lies_along(axes.forward, mirror) &&
           (is_square_to(axes.right, mirror) || is_square_to(axes.up, mirror));
}

} // namespace keiko
