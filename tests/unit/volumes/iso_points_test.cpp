#include "keiko/volumes/iso_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

TEST(IsoPoints, OfALinearFunctionLieOnItsPlane) {
    const std::array<int, 3> nodes{5, 6, 7};
    std::vector<float> values;
    for (int z = 0; z < nodes[2]; ++z)
        for (int y = 0; y < nodes[1]; ++y)
            for (int x = 0; x < nodes[0]; ++x)
                values.push_back(static_cast<float>(x + 2 * y - 4 * z));
    const VoxelGrid grid(nodes, std::move(values));
    const std::vector<Vec3> points = iso_points(grid, 0.3);
    for (const Vec3& point : points) {
        EXPECT_NEAR(point.x + 2 * point.y - 4 * point.z, 0.3, 1e-12);
        EXPECT_NEAR(grid.value(point), 0.3, 1e-12);
    }
    // Lines along z: one crossing a column that begins above and ends below.
    const auto along_z = std::count_if(points.begin(), points.end(), [](const Vec3& point) {
        return point.z != std::floor(point.z);
    });
    EXPECT_EQ(along_z, 5 * 6 - 1); // all but that of x = y = 0, which begins at 0
}

TEST(IsoPoints, OfABallLieOnItsSphere) {
    constexpr int count = 33;
    std::vector<float> values;
    for (int z = 0; z < count; ++z)
        for (int y = 0; y < count; ++y)
            for (int x = 0; x < count; ++x)
                values.push_back(static_cast<float>((Vec3(x, y, z) - Vec3(16)).length()));
    const std::vector<Vec3> points =
        iso_points(VoxelGrid({count, count, count}, std::move(values)), 12);
    EXPECT_GT(points.size(), 2000U);
    // Distances are linear along lines up to a share of a step over the radius.
    for (const Vec3& point : points) EXPECT_NEAR((point - Vec3(16)).length(), 12, 0.125 / 12);
}

TEST(IsoPoints, OfAValueBeyondAllAreNone) {
    EXPECT_TRUE(iso_points(VoxelGrid({2, 2, 2}, std::vector<float>(8, 0.5F)), 0.6).empty());
}

} // namespace
} // namespace keiko
