#include "keiko/light/fog/voxel_density.h"

#include "keiko/math/quadrature.h"
#include "keiko/math/trilinear.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keiko {

VoxelDensity::VoxelDensity(const Vec3& low, const Vec3& high, const std::array<int, 3>& nodes,
                           std::vector<double> values)
    : low_(low), high_(high), nodes_(nodes), values_(std::move(values)) {
    assert(std::min({nodes[0], nodes[1], nodes[2]}) >= 2);
    assert(values_.size() == static_cast<std::size_t>(nodes[0]) *
                                 static_cast<std::size_t>(nodes[1]) *
                                 static_cast<std::size_t>(nodes[2]));
}

double VoxelDensity::operator()(const Vec3& point) const {
    Vec3 place(0);
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (!(point[axis] >= low_[axis] && point[axis] <= high_[axis])) return 0;
        place[axis] = (point[axis] - low_[axis]) / (high_[axis] - low_[axis]) * (nodes_[axis] - 1);
    }
    const GridCell cell = grid_cell(place, nodes_);
    const auto row = static_cast<std::size_t>(nodes_[0]);
    const auto layer = row * static_cast<std::size_t>(nodes_[1]);
    const std::size_t first = cell.node[0] + row * cell.node[1] + layer * cell.node[2];
    return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
        return values_[first + x + row * y + layer * z];
    });
}

std::vector<double> VoxelDensity::crossings(const Segment& segment) const {
    const Vec3 way = segment.b - segment.a;
    double begin = 0, end = 1;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const double a = (low_[axis] - segment.a[axis]) / way[axis];
        const double b = (high_[axis] - segment.a[axis]) / way[axis];
        if (way[axis] == 0) {
            if (segment.a[axis] < low_[axis] || segment.a[axis] > high_[axis]) return {};
            continue;
        }
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin < end)) return {};
    std::vector<double> found;
    if (begin > 0) found.push_back(begin);
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) continue;
        const double step = (high_[axis] - low_[axis]) / (nodes_[axis] - 1);
        for (int i = 1; i + 1 < nodes_[axis]; ++i) {
            const double t = (low_[axis] + i * step - segment.a[axis]) / way[axis];
            if (t > begin && t < end) found.push_back(t);
        }
    }
    if (end < 1) found.push_back(end);
    std::sort(found.begin(), found.end());
    return found;
}

double VoxelDensity::mean_along(const Segment& segment) const {
    std::vector<double> ends = crossings(segment);
    ends.push_back(1);
    double sum = 0, begin = 0;
    for (const double end : ends) {
        sum += integrate([&](double t) { return (*this)(segment.at(t)); }, begin, end, 2);
        begin = end;
    }
    return sum;
}

} // namespace keiko
