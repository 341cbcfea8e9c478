#include "keiko/trace/plane_pair.h"

#include "keiko/trace/ray_blur.h"

#include <algorithm>
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
        noise += share * leaf.row_length[k] * blur * (1 + leaf.value[3]);
    }
    // The constant is that of every place of the ray, so that of a root on the leaf: below 2, as
    // the leaf's own blur takes it to be.
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
    const double along = std::sqrt(d.x * d.x + d.y * d.y), length = d.length();
    // A ray along the normal has no direction over the leaf; any will do.
    const Vec2 over = along > 0 ? Vec2(d.x, d.y) / along : Vec2(1, 0);
    // The rounding of the foot point is that of the way there, and of the rows' turning it.
    seen.blur =
        ray.error + leaf.blur + 2 * ray_rounding * (std::abs(seen.foot_s) + to_center.length());
    set_plane(seen, leaf, 0, {over.x * d.z / length, over.y * d.z / length, -along / length},
              seen.blur);
    set_plane(seen, leaf, 1, {-over.y, over.x, 0}, seen.blur);
    return seen;
}

Box2 reachable(const FrameRay& ray, const HotLeaf& leaf) {
    Box2 box{Vec2(-1), Vec2(1)};
    const Vec3& d = ray.direction;
    // Lower rays meet the plane too far off, or not at all.
    constexpr double lowest = 1e-3;
    if (!(std::abs(d.z) > lowest * d.length())) return box;
    for (unsigned k = 0; k < 2; ++k) {
        const double turn = d[k] / d.z, place = ray.foot[k] - ray.foot.z * turn;
        const double strip = leaf.value[k] + std::abs(turn) * leaf.value[2] +
                             std::abs(place) * leaf.value[3] +
                             ray.blur * (leaf.row_length[k] + std::abs(turn) * leaf.row_length[2]);
        box.lower[k] = std::max(box.lower[k], place - strip * (1 + 1e-9));
        box.upper[k] = std::min(box.upper[k], place + strip * (1 + 1e-9));
    }
    return box;
}

} // namespace keiko
