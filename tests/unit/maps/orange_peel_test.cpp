#include "keiko/maps/orange_peel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace keiko {
namespace {

TEST(OrangePeel, RmsHeightIsThatOfItsBands) {
    const OrangePeel peel({0.1, 0.2, 0.4, 0.3, 0.2}, 3);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1000, 1000);
    double squares = 0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const double h =
            peel.height({Vec3(place(random), place(random), place(random))}).value * 1e3;
        squares += h * h / count;
    }
    const double expected = 0.1 * 0.1 + 0.2 * 0.2 + 0.4 * 0.4 + 0.3 * 0.3 + 0.2 * 0.2;
    EXPECT_NEAR(std::sqrt(squares), std::sqrt(expected), 0.02 * std::sqrt(expected));
}

TEST(OrangePeel, DerivativesAreThoseOfDifferences) {
    const OrangePeel peel({0, 0.2, 0.4, 0.3, 0.2}, 3);
    const Vec3 at(3.1, -2.2, 0.7);
    const HeightJet jet = peel.height({at});
    constexpr double step = 1e-4;
    for (int i = 0; i < 3; ++i) {
        Vec3 e(0);
        e[i] = 1;
        const HeightJet after = peel.height({at + e * step}), before = peel.height({at - e * step});
        EXPECT_NEAR(jet.gradient.dot(e), (after.value - before.value) / (2 * step), 1e-9);
        for (int j = 0; j < 3; ++j) {
            Vec3 f(0);
            f[j] = 1;
            EXPECT_NEAR(jet.along(e, f), (after.gradient - before.gradient).dot(f) / (2 * step),
                        1e-6);
        }
    }
}

/// Waves of one band look like their wavelength: crossings of zero along a line across a surface
/// lie at least half the shortest wave apart, and pixels of several waves see none of them.
TEST(OrangePeel, BandsHoldTheirWavelengths) {
    const OrangePeel band({0, 0, 1, 0, 0}, 8);
    const double slope = band.height({Vec3(0)}).gradient.length();
    EXPECT_LT(slope, 1e-3 * 2 * std::numbers::pi / orange_peel_bands[2] * std::sqrt(48.0));
    int crossings = 0;
    constexpr double length = 3000, step = 0.05;
    for (double x = 0; x < length; x += step)
        crossings +=
            band.height({Vec3(x, 0, 0)}).value * band.height({Vec3(x + step, 0, 0)}).value < 0;
    // A cut through waves of all directions shows those of a wavelength l with a mean square
    // frequency of 1 / (3 l^2).
    EXPECT_GT(crossings, 2 * length / (std::sqrt(3.0) * orange_peel_bands[3]));
    EXPECT_LT(crossings, 2 * length / (std::sqrt(3.0) * orange_peel_bands[2]));
    const HeightJet far = band.height({Vec3(1, 2, 3), Vec3(60, 0, 0), Vec3(0, 60, 0)});
    EXPECT_LT(far.gradient.length(), 0.2 * slope);
}

} // namespace
} // namespace keiko
