#include "keiko/compare/scan/scan_map.h"

#include "keiko/compare/scan/point_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// The measured points of a scan, by their closest points.
struct MeasuredPoints {
    std::vector<Vec3> closest;
    std::vector<double> distance; ///< mm

    explicit MeasuredPoints(std::span<const PointDeviation> points) {
        for (const PointDeviation& point : points)
            if (point.is_measured())
                closest.push_back(point.closest), distance.push_back(point.distance);
    }
};

} // namespace

double map_radius(std::span<const PointDeviation> points, double nominal_size) {
    constexpr double spacings = 1.5, share = 1.0 / 500;
    return std::max(spacings * point_spacing(MeasuredPoints(points).closest), share * nominal_size);
}

DeviationMap scan_map(const Tracer& nominal, const Camera& camera,
                      std::span<const PointDeviation> points, double radius, const Job& job) {
    const MeasuredPoints measured(points);
    const PointGrid grid(measured.closest, radius);
    const HitValue value = [&](const Hit& hit) {
        const std::vector<std::uint32_t> near = grid.near_points(hit.position);
        double sum = 0;
        for (const std::uint32_t i : near) sum += measured.distance[i];
        return near.empty() ? std::numeric_limits<float>::quiet_NaN()
                            : static_cast<float>(sum / static_cast<double>(near.size()));
    };
    return surface_map(
        nominal, camera, [&] { return value; }, job);
}

} // namespace keiko
