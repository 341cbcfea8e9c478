#include "keiko/maps/map_region.h"

#include "keiko/math/polygon.h"

#include <gtest/gtest.h>

#include <vector>

namespace keiko {
namespace {

const std::vector<Vec2> arrow{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};

TEST(MapRegion, CoverageIsTheAreaInThePixel) {
    const TexturePlace pixel{Vec3(2.2, 1.1, 0), Vec3(2.5, 0.4, 0), Vec3(-0.5, 1.7, 0)};
    constexpr int side = 600;
    int inside = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const Vec3 at = pixel.at + pixel.dx * ((i + 0.5) / side - 0.5) +
                            pixel.dy * ((j + 0.5) / side - 0.5);
            inside += holds(arrow, Vec2(at.x, at.y)) ? 1 : 0;
        }
    const double expected = static_cast<double>(inside) / (side * side);
    EXPECT_NEAR(polygon_coverage(arrow, pixel), expected, 2e-3);
    const TexturePlace mirrored{pixel.at, pixel.dy, pixel.dx};
    EXPECT_NEAR(polygon_coverage(arrow, mirrored), expected, 2e-3);
}

TEST(MapRegion, PixelsWithinAndBesideItAreWholeAndEmpty) {
    const Vec3 x(0.1, 0, 0), y(0, 0.1, 0);
    EXPECT_DOUBLE_EQ(polygon_coverage(arrow, {Vec3(0.5, 0.5, 0), x, y}), 1);
    EXPECT_DOUBLE_EQ(polygon_coverage(arrow, {Vec3(2, 2.5, 0), x, y}), 0); // in its notch
}

TEST(MapRegion, PixelsWithoutAreaAreInOrOut) {
    EXPECT_EQ(polygon_coverage(arrow, {Vec3(0.5, 0.5, 0)}), 1);
    EXPECT_EQ(polygon_coverage(arrow, {Vec3(2, 2.5, 0)}), 0);
}

} // namespace
} // namespace keiko
