#include "keiko/trace/plane_pair.h"

#include "keiko/trace/ray_blur.h"

#include <cmath>

namespace keiko {
namespace {

Vec3 vec(const std::array<double, 3>& a) {
    return {a[0], a[1], a[2]};
}

void set_plane(FrameRay& seen, const HotLeaf& leaf, std::size_t which, const Vec3& normal,
               double blur) {
    seen.planes.weights[which] = {normal.x, normal.y, normal.z, -normal.dot(seen.foot)};
    double bend = 0, noise = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = std::abs(normal[static_cast<unsigned>(k)]);
        bend += share * leaf.bend[k];
        noise += share * leaf.row_length[k] * blur;
    }
    seen.planes.bend[which] = bend + std::abs(normal.dot(seen.foot)) * leaf.bend[3];
    seen.planes.noise[which] = noise;
}

} // namespace

FrameRay frame_ray(const TracedRay& ray, const HotLeaf& leaf) {
    const auto in_frame = [&](const Vec3& v) {
        return Vec3(vec(leaf.rows[0]).dot(v), vec(leaf.rows[1]).dot(v), vec(leaf.rows[2]).dot(v));
    };
    FrameRay seen;
    const Vec3 to_center = vec(leaf.center) - ray.start;
    seen.foot_s = to_center.dot(ray.direction);
    seen.foot = in_frame(ray.direction * seen.foot_s - to_center);
    seen.direction = in_frame(ray.direction);
    const Vec3& d = seen.direction;
    const double along = std::hypot(d.x, d.y), length = std::hypot(along, d.z);
    // A ray along the normal has no direction over the leaf; any will do.
    const Vec2 over = along > 0 ? Vec2(d.x, d.y) / along : Vec2(1, 0);
    // The rounding of the foot point is that of the way there, and of the rows' turning it.
    const double blur =
        ray.error + leaf.blur + 2 * ray_rounding * (std::abs(seen.foot_s) + to_center.length());
    set_plane(seen, leaf, 0, {over.x * d.z / length, over.y * d.z / length, -along / length}, blur);
    set_plane(seen, leaf, 1, {-over.y, over.x, 0}, blur);
    return seen;
}

} // namespace keiko
