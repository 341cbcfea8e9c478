#include "keiko/compare/deviation_map.h"

#include "keiko/base/parallel.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

float signed_distance(const SurfaceFeet& other, const Vec3& place, double reach) {
    const auto foot = other.foot(place, reach);
    if (!foot) return std::numeric_limits<float>::infinity();
    const bool inside = (place - foot->position).dot(foot->normal) < 0;
    return static_cast<float>(inside ? -foot->distance : foot->distance);
}

} // namespace

DeviationMap deviation_map(const Tracer& body, const Camera& camera, const SurfaceFeet& other,
                           double reach, const Job& job) {
    DeviationMap map{Image(camera.width, camera.height, 1, std::numeric_limits<float>::quiet_NaN()),
                     Image(camera.width, camera.height, 1)};
    parallel_for(static_cast<std::size_t>(camera.height), job, "deviation map", [&](std::size_t y) {
        const int row = static_cast<int>(y);
        std::vector<Ray> rays;
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, row + 0.5));
        const std::vector<std::optional<Hit>> hits = body.nearest(rays);
        for (int x = 0; x < camera.width; ++x) {
            const auto& hit = hits[static_cast<std::size_t>(x)];
            if (!hit) continue;
            *map.distance.pixel(x, row) = signed_distance(other, hit->position, reach);
            const Vec3 view = rays[static_cast<std::size_t>(x)].direction.normalized();
            *map.facing.pixel(x, row) = static_cast<float>(std::abs(view.dot(hit->normal)));
        }
    });
    return map;
}

} // namespace keiko
