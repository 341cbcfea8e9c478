#include "keiko/volumes/voxel_filters.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keiko {
namespace {

constexpr std::array<int, 3> nodes{7, 6, 5};

std::size_t index(int x, int y, int z) {
    return static_cast<std::size_t>(x + nodes[0] * (y + nodes[1] * z));
}

std::vector<float> noise() {
    std::vector<float> values;
    unsigned state = 7;
    for (int i = 0; i < nodes[0] * nodes[1] * nodes[2]; ++i) {
        state = state * 1664525U + 1013904223U;
        values.push_back(static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U));
    }
    return values;
}

TEST(MedianFilter, ReturnsTheMiddleOfEachCube) {
    const std::vector<float> values = noise();
    const std::vector<float> smooth = filtered(MedianFilter{1}, values, nodes, Vec3(1), {});
    std::vector<float> cube;
    for (int z = 1; z <= 3; ++z)
        for (int y = 2; y <= 4; ++y)
            for (int x = 2; x <= 4; ++x) cube.push_back(values[index(x, y, z)]);
    std::sort(cube.begin(), cube.end());
    EXPECT_EQ(smooth[index(3, 3, 2)], cube[13]);
}

TEST(MedianFilter, RemovesSingleOutliersAndKeepsAnEdge) {
    std::vector<float> values(noise().size());
    for (int z = 0; z < nodes[2]; ++z)
        for (int y = 0; y < nodes[1]; ++y)
            for (int x = 3; x < nodes[0]; ++x) values[index(x, y, z)] = 1;
    const std::vector<float> edge = values;
    values[index(1, 2, 2)] = 1, values[index(5, 4, 3)] = 0;
    EXPECT_EQ(filtered(MedianFilter{1}, values, nodes, Vec3(1), {}), edge);
}

TEST(GaussFilter, SpreadsAPointAsTheGaussianOfItsDistance) {
    std::vector<float> values(noise().size());
    values[index(3, 3, 2)] = 1;
    const Vec3 spacing(1, 2, 4);
    const std::vector<float> spread = filtered(GaussFilter{1.5}, values, nodes, spacing, {});
    const auto ratio = [&](int x, int y, int z) {
        return static_cast<double>(spread[index(x, y, z)] / spread[index(3, 3, 2)]);
    };
    for (const auto& [x, y, z] : {std::array{4, 3, 2}, std::array{3, 2, 2}, std::array{4, 4, 2}}) {
        const Vec3 away((x - 3) * spacing.x, (y - 3) * spacing.y, (z - 2) * spacing.z);
        EXPECT_NEAR(ratio(x, y, z), std::exp(-away.length2() / (2 * 1.5 * 1.5)), 1e-6);
    }
}

TEST(GaussFilter, KeepsUniformValues) {
    const std::vector<float> values(noise().size(), 0.7F);
    for (const float value : filtered(GaussFilter{2}, values, nodes, Vec3(1), {}))
        EXPECT_NEAR(value, 0.7F, 1e-6F);
}

TEST(VoxelFilters, DoNotDependOnTheNumberOfThreads) {
    for (const VoxelFilter& filter : {VoxelFilter(MedianFilter{2}), VoxelFilter(GaussFilter{1})})
        EXPECT_EQ(filtered(filter, noise(), nodes, Vec3(1), {.threads = 1}),
                  filtered(filter, noise(), nodes, Vec3(1), {.threads = 2}));
}

} // namespace
} // namespace keiko
