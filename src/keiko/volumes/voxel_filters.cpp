#include "keiko/volumes/voxel_filters.h"

#include "keiko/base/error.h"
#include "keiko/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace keiko {
namespace {

/// Numbers of the nodes of a grid, clamped to its borders.
struct Nodes {
    std::array<int, 3> count;

    std::size_t operator()(int x, int y, int z) const {
        const auto at = [&](int i, std::size_t axis) {
            return static_cast<std::size_t>(std::clamp(i, 0, count[axis] - 1));
        };
        return at(x, 0) + static_cast<std::size_t>(count[0]) *
                              (at(y, 1) + static_cast<std::size_t>(count[1]) * at(z, 2));
    }
};

/// The values of all nodes, layer by layer on the threads of the job.
template <class AtNode>
std::vector<float> each_node(const Nodes& nodes, const Job& job, const AtNode& at_node) {
    const auto [wide, deep, high] = nodes.count;
    std::vector<float> values(nodes(wide, deep, high) + 1);
    parallel_for(static_cast<std::size_t>(high), job, "", [&, wide = wide, deep = deep](auto z) {
        for (int y = 0; y < deep; ++y)
            for (int x = 0; x < wide; ++x) {
                const int layer = static_cast<int>(z);
                values[nodes(x, y, layer)] = at_node(x, y, layer);
            }
    });
    return values;
}

std::vector<float> passed(const MedianFilter& filter, const std::vector<float>& values,
                          const Nodes& nodes, const Vec3&, const Job& job) {
    const int r = filter.radius;
    return each_node(nodes, job, [&](int x, int y, int z) {
        std::vector<float> cube;
        for (int k = -r; k <= r; ++k)
            for (int j = -r; j <= r; ++j)
                for (int i = -r; i <= r; ++i) cube.push_back(values[nodes(x + i, y + j, z + k)]);
        const auto middle = cube.begin() + static_cast<std::ptrdiff_t>(cube.size() / 2);
        std::nth_element(cube.begin(), middle, cube.end());
        return *middle;
    });
}

/// Weights of the neighbours from 0 to `reach` steps away, which with both sides sum up to 1.
std::vector<double> gauss_weights(double width, double spacing) {
    constexpr double reach = 4;   // widths, beyond which 6e-5 of a Gaussian lie
    constexpr double widest = 64; // spacings: more takes hours
    if (width > widest * spacing)
        throw FieldError("filter.width", "is more than 64 spacings of the voxels");
    std::vector<double> weights;
    double sum = 0;
    for (int i = 0; i <= reach * width / spacing; ++i) {
        const double away = i * spacing / width;
        weights.push_back(std::exp(-away * away / 2));
        sum += weights.back() * (i == 0 ? 1 : 2);
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

std::vector<float> passed(const GaussFilter& filter, std::vector<float> values, const Nodes& nodes,
                          const Vec3& spacing, const Job& job) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        const std::vector<double> weights = gauss_weights(filter.width, spacing[axis]);
        values = each_node(nodes, job, [&](int x, int y, int z) {
            const auto value = [&](int steps) -> double {
                return values[nodes(x + (axis == 0 ? steps : 0), y + (axis == 1 ? steps : 0),
                                    z + (axis == 2 ? steps : 0))];
            };
            double sum = weights.front() * value(0);
            for (int i = 1; i < static_cast<int>(weights.size()); ++i)
                sum += weights[static_cast<std::size_t>(i)] * (value(i) + value(-i));
            return static_cast<float>(sum);
        });
    }
    return values;
}

} // namespace

std::vector<float> filtered(const VoxelFilter& filter, std::vector<float> values,
                            const std::array<int, 3>& nodes, const Vec3& spacing, const Job& job) {
    return std::visit(
        [&](const auto& kind) {
            return passed(kind, std::move(values), Nodes{nodes}, spacing, job);
        },
        filter);
}

} // namespace keiko
