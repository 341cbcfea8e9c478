#include "keiko/compare/shape/deviation_map.h"

#include "keiko/base/parallel.h"

#include <cmath>
#include <limits>
#include <optional>

namespace keiko {
namespace {

/// Signed distances of places that follow each other closely: from one to the next a distance grows
/// by no more than the way, which bounds the search.
class DistanceRow {
public:
    DistanceRow(const ClosestPointQuery& other, double reach) : other_(other), reach_(reach) {}

    float at(const Vec3& place) {
        const auto foot = foot_of(place);
        last_ = place;
        last_distance_ = foot ? foot->distance : std::numeric_limits<double>::infinity();
        if (!foot) return std::numeric_limits<float>::infinity();
        const bool inside = (place - foot->position).dot(foot->normal) < 0;
        return static_cast<float>(inside ? -foot->distance : foot->distance);
    }

private:
    std::optional<ClosestSurfacePoint> foot_of(const Vec3& place) const {
        constexpr double rounding = 1e-6; // mm
        const double bound = last_distance_ + (place - last_).length() + rounding;
        if (bound < reach_)
            if (auto foot = other_.foot(place, bound)) return foot;
        return other_.foot(place, reach_);
    }

    const ClosestPointQuery& other_;
    double reach_;
    Vec3 last_{0};
    double last_distance_ = std::numeric_limits<double>::infinity(); ///< mm
};

} // namespace

DeviationMap deviation_map(const Tracer& body, const Camera& camera, const ClosestPointQuery& other,
                           double reach, const Job& job) {
    DeviationMap map{Image(camera.width, camera.height, 1, std::numeric_limits<float>::quiet_NaN()),
                     Image(camera.width, camera.height, 1)};
    parallel_for(static_cast<std::size_t>(camera.height), job, "deviation map", [&](std::size_t y) {
        const int row = static_cast<int>(y);
        std::vector<Ray> rays;
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, row + 0.5));
        const std::vector<std::optional<Hit>> hits = body.nearest(rays);
        DistanceRow distances(other, reach);
        for (int x = 0; x < camera.width; ++x) {
            const auto& hit = hits[static_cast<std::size_t>(x)];
            if (!hit) continue;
            *map.distance.pixel(x, row) = distances.at(hit->position);
            const Vec3 view = rays[static_cast<std::size_t>(x)].direction.normalized();
            *map.facing.pixel(x, row) = static_cast<float>(std::abs(view.dot(hit->normal)));
        }
    });
    return map;
}

} // namespace keiko
