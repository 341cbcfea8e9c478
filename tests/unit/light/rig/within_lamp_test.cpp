#include "keiko/light/rig/prepared_rig.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

/// Two tubes of 1 m along x, 20 mm thick, their axes at y = 50 and y = 150.
const CPlane row{
    .origin = {0, 0, 500}, .u = {1000, 0, 0}, .v = {0, 200, 0}, .lamps = 2, .diameter = 20};

TEST(WithinLamp, IsInsideTheGlassOfATubeAndBetweenItsEnds) {
    for (const double y : {50.0, 150.0}) {
        EXPECT_TRUE(within_lamp(row, {500, y, 500}));
        EXPECT_TRUE(within_lamp(row, {1, y + 7, 507})) << "9.9 mm off the axis";
        EXPECT_FALSE(within_lamp(row, {1, y + 8, 508}));
        EXPECT_FALSE(within_lamp(row, {500, y, 490})) << "on the glass";
        EXPECT_FALSE(within_lamp(row, {-1, y, 500})) << "past the end";
        EXPECT_FALSE(within_lamp(row, {1000, y, 500})) << "on the cap";
    }
    EXPECT_FALSE(within_lamp(row, {500, 100, 500})) << "between the tubes";
}

TEST(WithinLamp, IsWherePointLightsAreAndNeverInTheSun) {
    const Spotlight spot{.position = {1, 2, 3}, .aim = Vec3(0)};
    EXPECT_TRUE(within_lamp(spot, {1, 2, 3}));
    EXPECT_FALSE(within_lamp(spot, {1, 2, 4}));
    EXPECT_FALSE(within_lamp(Sun{}, Vec3(0)));
}

} // namespace
} // namespace keiko
