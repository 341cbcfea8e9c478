#include "tests/bench/embree_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// How far along the ray it first leaves a layer of `lift` mm over the surface it starts on.
double lifted(const RaySet& rays, std::size_t i, double lift) {
    if (rays.leaving_sine.empty()) return 0;
    return lift / std::max(rays.leaving_sine[i], 1e-3);
}

} // namespace

EmbreeRays::EmbreeRays(const RaySet& rays, const Ball& ball, Mode mode, const Options& options) {
    const std::size_t count = rays.rays.size();
    if (mode == Mode::single)
        singles.resize(count);
    else
        packets.resize((count + 15) / 16);
    for (Packet& packet : packets) packet.valid.fill(0);
    for (std::size_t i = 0; i < count; ++i) {
        const Ray& ray = rays.rays[i];
        const double speed = ray.direction.length();
        const Vec3 direction = ray.direction / speed;
        const Vec3 to_center = ball.center - ray.origin;
        const double foot = to_center.dot(direction);
        const double half2 = ball.radius * ball.radius - (to_center - direction * foot).length2();
        const double half = half2 > 0 ? std::sqrt(half2) : 0;
        const double begin = std::max(0.0, foot - half);
        Start start{begin / speed, 1 / speed, static_cast<float>(lifted(rays, i, options.lift)),
                    infinity};
        if (options.end_at_hit && rays.truth[i])
            start.far = round_up(rays.truth[i]->t * speed - begin);
        if (!(half2 > 0)) start.far = -infinity;
        starts_.push_back(start);
        write(i, ray.origin + direction * begin - ball.center, direction);
    }
    reset();
}

void EmbreeRays::write(std::size_t i, const Vec3& origin, const Vec3& direction) {
    const auto f = [](double x) { return static_cast<float>(x); };
    if (!singles.empty()) {
        RTCRay& ray = singles[i].ray;
        ray = {};
        ray.org_x = f(origin.x), ray.org_y = f(origin.y), ray.org_z = f(origin.z);
        ray.dir_x = f(direction.x), ray.dir_y = f(direction.y), ray.dir_z = f(direction.z);
        ray.mask = 0xffffffff;
        return;
    }
    Packet& packet = packets[i / 16];
    RTCRay16& ray = packet.rays.ray;
    const std::size_t k = i % 16;
    ray.org_x[k] = f(origin.x), ray.org_y[k] = f(origin.y), ray.org_z[k] = f(origin.z);
    ray.dir_x[k] = f(direction.x), ray.dir_y[k] = f(direction.y), ray.dir_z[k] = f(direction.z);
    ray.time[k] = 0;
    ray.mask[k] = 0xffffffff;
    ray.id[k] = ray.flags[k] = 0;
    packet.valid[k] = starts_[i].far >= starts_[i].near ? -1 : 0;
}

void EmbreeRays::reset() {
    for (std::size_t i = 0; i < starts_.size(); ++i)
        if (!singles.empty()) {
            singles[i].ray.tnear = starts_[i].near;
            singles[i].ray.tfar = starts_[i].far;
            singles[i].hit.geomID = singles[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        } else {
            RTCRayHit16& rays = packets[i / 16].rays;
            rays.ray.tnear[i % 16] = starts_[i].near;
            rays.ray.tfar[i % 16] = starts_[i].far;
            rays.hit.geomID[i % 16] = rays.hit.instID[0][i % 16] = RTC_INVALID_GEOMETRY_ID;
        }
}

std::optional<EmbreeHit> EmbreeRays::hit(std::size_t i) const {
    const auto t = [&](double far) { return starts_[i].t + far * starts_[i].per_mm; };
    if (!singles.empty()) {
        const RTCRayHit& ray = singles[i];
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
        return EmbreeHit{ray.hit.primID, t(static_cast<double>(ray.ray.tfar)), ray.hit.u,
                         ray.hit.v};
    }
    const RTCRayHit16& rays = packets[i / 16].rays;
    const std::size_t k = i % 16;
    if (rays.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return EmbreeHit{rays.hit.primID[k], t(static_cast<double>(rays.ray.tfar[k])), rays.hit.u[k],
                     rays.hit.v[k]};
}

} // namespace keiko::bench
