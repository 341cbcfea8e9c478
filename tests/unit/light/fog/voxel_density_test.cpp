#include "keiko/light/fog/voxel_density.h"

#include "keiko/math/quadrature.h"

#include <gtest/gtest.h>

using namespace keiko;

namespace {

/// x + 2 y z over the unit cube times 1000 mm, which a trilinear grid holds exactly.
VoxelDensity bilinear() {
    std::vector<double> values;
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 2; ++i) values.push_back(i + 2 * (j / 3.0) * (k / 2.0));
    return {Vec3(0), Vec3(1000), {2, 4, 3}, values};
}

} // namespace

TEST(VoxelDensity, IsTrilinearInsideAndNothingOutside) {
    const VoxelDensity density = bilinear();
    EXPECT_NEAR(density({300, 400, 700}), 0.3 + 2 * 0.4 * 0.7, 1e-15);
    EXPECT_NEAR(density(Vec3(1000)), 3, 1e-15);
    EXPECT_EQ(density({1001, 500, 500}), 0);
    EXPECT_EQ(density({500, -1, 500}), 0);
}

TEST(VoxelDensity, MeanAlongASegmentIsExact) {
    const VoxelDensity density = bilinear();
    const Segment ray{{-500, 200, 100}, {1500, 900, 800}};
    const double begin = 0.25, end = 0.75; // inside the box
    const auto exact = integrate([&](double t) { return density(ray.at(t)); }, begin, end, 12);
    EXPECT_NEAR(density.mean_along(ray), exact, 1e-15);
    EXPECT_EQ(density.crossings(ray).front(), begin);
    EXPECT_EQ(density.crossings(ray).back(), end);
    EXPECT_EQ(density.mean_along({{0, 0, 1001}, {1000, 1000, 1001}}), 0);
}
