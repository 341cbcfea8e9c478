#include "keiko/light/luminance/photometry.h"

#include <gtest/gtest.h>

using namespace keiko;

TEST(Photometry, InverseSquareCountsMetres) {
    // 1000 cd at 2 m, head on: 250 lx.
    EXPECT_DOUBLE_EQ(inverse_square_illuminance(Rgb(1000), 2000, 1).g, 250);
    EXPECT_DOUBLE_EQ(inverse_square_illuminance(Rgb(1000), 2000, 0.5).r, 125);
    EXPECT_EQ(inverse_square_illuminance(Rgb(1000), 2000, -0.5), Rgb());
    EXPECT_EQ(inverse_square_illuminance(Rgb(1000), 0, 1), Rgb());
}

TEST(Photometry, TubeLuminanceOfADataSheet) {
    // T8, 36 W: 3350 lm, 26 mm, 1200 mm: 10 900 cd/m2 (docs/theory/luminance.md#a-tube).
    EXPECT_NEAR(tube_luminance(3350, 26, 1200), 10900, 25);
    // Half of the flux per length from twice the diameter is a quarter of the luminance.
    EXPECT_DOUBLE_EQ(tube_luminance(3350, 52, 2400), tube_luminance(3350, 26, 1200) / 4);
    // Discs of pi r^2 each add to the lateral pi d l.
    EXPECT_DOUBLE_EQ(tube_luminance(100, 40, 20, true), tube_luminance(100, 40, 40));
}

TEST(Photometry, WhitePaperUnderPiLux) {
    EXPECT_DOUBLE_EQ(lambert_luminance(Rgb(0.5), Rgb(std::numbers::pi)).g, 0.5);
}
