#include "keiko/volumes/iso_points.h"

namespace keiko {
namespace {

/// Adds the crossings of the lines along an axis.
void add_along(unsigned axis, const VoxelGrid& grid, double value, std::vector<Vec3>& points) {
    std::array<std::size_t, 3> ends{};
    for (std::size_t k = 0; k < 3; ++k) ends[k] = static_cast<std::size_t>(grid.nodes()[k]);
    const std::size_t next = axis == 0   ? grid.index(1, 0, 0)
                             : axis == 1 ? grid.index(0, 1, 0)
                                         : grid.index(0, 0, 1);
    --ends[axis]; // the last node has no next
    for (std::size_t z = 0; z < ends[2]; ++z)
        for (std::size_t y = 0; y < ends[1]; ++y)
            for (std::size_t x = 0; x < ends[0]; ++x) {
                const std::size_t node = grid.index(x, y, z);
                const auto here = static_cast<double>(grid.values()[node]);
                const auto there = static_cast<double>(grid.values()[node + next]);
                if ((here < value) == (there < value)) continue;
                Vec3 point(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
                point[axis] += (value - here) / (there - here);
                points.push_back(point);
            }
}

} // namespace

std::vector<Vec3> iso_points(const VoxelGrid& grid, double value) {
    std::vector<Vec3> points;
    for (const unsigned axis : {0U, 1U, 2U}) add_along(axis, grid, value, points);
    return points;
}

} // namespace keiko
