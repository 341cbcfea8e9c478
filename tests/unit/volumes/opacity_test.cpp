#include "keiko/volumes/opacity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

TEST(Opacity, OfLayersFollowsFromTheSumOfTheirDepths) {
    for (const double a : {0.0, 1e-9, 0.3, 0.999}) {
        EXPECT_NEAR(opacity_of_depth(depth_of_opacity(a)), a, 1e-15);
        const double two = opacity_of_depth(2 * depth_of_opacity(a));
        EXPECT_NEAR(1 - two, (1 - a) * (1 - a), 1e-15);
    }
    EXPECT_TRUE(std::isfinite(depth_of_opacity(1)));
}

TEST(Opacity, OfAContourFallsToNothingByTheDistanceToIt) {
    const ContourOpacity contour{.value = 0.5, .thickness = 2, .opacity = 0.8};
    EXPECT_EQ(contour_opacity(contour, 0.5, 0), 0.8);
    EXPECT_EQ(contour_opacity(contour, 0.51, 0), 0);
    EXPECT_NEAR(contour_opacity(contour, 0.6, 0.1), 0.4, 1e-12);
    EXPECT_NEAR(contour_opacity(contour, 0.4, 0.1), 0.4, 1e-12);
    EXPECT_EQ(contour_opacity(contour, 0.75, 0.1), 0);
}

TEST(Opacity, OfARegionIsZeroOutsideAndOneAtMost) {
    const RegionOpacity region{.low = 0.2, .high = 0.4, .opacity_low = 1, .opacity_high = 3};
    EXPECT_EQ(region_opacity(region, 0.19, 1), 0);
    EXPECT_EQ(region_opacity(region, 0.41, 1), 0);
    EXPECT_NEAR(region_opacity(region, 0.3, 0.1), 0.2, 1e-12);
    EXPECT_EQ(region_opacity(region, 0.4, 1), 1);
}

TEST(Opacity, OfANodeAddsAllThatMakesItOpaque) {
    VolumeSpec spec;
    spec.extinction.points = {{0, 0}, {1, 1000}}; // 1/m
    spec.contours = {{.value = 0.5, .thickness = 2, .opacity = 0.8}};
    spec.regions = {{.low = 0, .high = 1, .opacity_low = 1, .opacity_high = 1}};
    EXPECT_NEAR(node_depth(spec, 2, 0.5, 0.1), 0.5 * 2 - std::log(1 - 0.8) - std::log(1 - 0.1),
                1e-12);
}

TEST(ValueTable, IsStraightBetweenItsPointsAndConstantBeyond) {
    const ValueTable<double> table{{{1, 10}, {2, 20}, {4, 0}}};
    EXPECT_EQ(table(0), 10);
    EXPECT_EQ(table(1.5), 15);
    EXPECT_EQ(table(3), 10);
    EXPECT_EQ(table(9), 0);
}

} // namespace
} // namespace keiko
