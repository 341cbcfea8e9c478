#include "keiko/maps/patterns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// Mean of a value without a pixel over a grid of places in a rectangle.
template <class Value>
double mean_over(const TexturePlace& place, const Value& value) {
    constexpr int side = 400;
    double sum = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            sum += value(TexturePlace{place.at + place.dx * ((i + 0.5) / side - 0.5) +
                                      place.dy * ((j + 0.5) / side - 0.5)});
    return sum / (side * side);
}

/// The mean is exact in pixels whose sides lie along the coordinates.
TEST(Patterns, PixelsShowTheirMean) {
    for (const double size : {0.05, 0.3, 0.77, 2.4})
        for (const Vec3& at : {Vec3(0.02, 0.31, 0), Vec3(-3.4, 7.98, 0), Vec3(12.5, -0.01, 0)}) {
            const TexturePlace place{at, Vec3(size, 0, 0), Vec3(0, 0.6 * size, 0)};
            EXPECT_NEAR(checker(place), mean_over(place, checker), 0.01);
            const auto lines = [](const TexturePlace& p) { return grid_lines(p, 0.1, false); };
            EXPECT_NEAR(lines(place), mean_over(place, lines), 0.01);
            const auto bond = [](const TexturePlace& p) {
                return bricks(p, {.width = 1.2, .height = 0.5, .mortar = 0.1});
            };
            const double height = 0.6 * size;
            const double row = std::floor(at.y / 0.5);
            const bool within_row = std::floor((at.y - height / 2) / 0.5) == row &&
                                    std::floor((at.y + height / 2) / 0.5) == row;
            if (within_row) {
                EXPECT_NEAR(bond(place), mean_over(place, bond), 0.01);
            }
        }
}

/// A pixel that has a width of rounding across a coordinate shows the place itself.
TEST(Patterns, ExtentsOfRoundingAreNone) {
    for (const double width : {1e-19, 1e-17, 3e-16, 1e-14, 1e-12})
        for (const double x : {12.25, 12.75, 13.5, -3.25}) {
            const TexturePlace place{Vec3(x, 0.5, 0.5), Vec3(width, 0.2, 0), Vec3(0, width, 0.2)};
            EXPECT_NEAR(checker(place), checker({place.at}), 1e-12) << width << ' ' << x;
            EXPECT_NEAR(grid_lines(place, 0.1, true), grid_lines({place.at}, 0.1, true), 1e-12);
        }
}

TEST(Patterns, WoodAndMarbleFadeToGrey) {
    const TexturePlace wide{Vec3(0.3, 0.2, 0.1), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    EXPECT_DOUBLE_EQ(wood(wide, 0.3, 1), 0.5);
    EXPECT_DOUBLE_EQ(marble(wide, 3, {}), 0.5);
}

TEST(Patterns, GridOfSpaceHasPlanesAcrossAllAxes) {
    EXPECT_EQ(grid_lines({Vec3(0.5, 0.5, 0.01)}, 0.1, true), 1);
    EXPECT_EQ(grid_lines({Vec3(0.5, 0.5, 0.01)}, 0.1, false), 0);
}

} // namespace
} // namespace keiko
