#include "keiko/math/sincos_2pi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace keiko;

namespace {

void expect_near_exact(const std::vector<double>& turns) {
    std::vector<double> cosines(turns.size()), sines(turns.size());
    sincos_2pi(turns, cosines, sines);
    for (std::size_t i = 0; i < turns.size(); ++i) {
        // In long double, of the part of a turn, which is exact.
        const long double angle =
            2 * std::numbers::pi_v<long double> * (turns[i] - std::round(turns[i]));
        EXPECT_NEAR(cosines[i], static_cast<double>(std::cos(angle)), 4e-16) << turns[i];
        EXPECT_NEAR(sines[i], static_cast<double>(std::sin(angle)), 4e-16) << turns[i];
    }
}

} // namespace

TEST(TurnSines, AreThoseOfTheLibrary) {
    std::mt19937 random(5);
    for (const double reach : {1e-3, 1.0, 1e4, 1e9}) {
        std::uniform_real_distribution<double> any(-reach, reach);
        std::vector<double> turns;
        for (int i = 0; i < 10001; ++i) turns.push_back(any(random));
        expect_near_exact(turns);
    }
}

TEST(TurnSines, OfHalfTurnsAreExact) {
    std::vector<double> turns;
    for (int i = -40; i <= 40; ++i) turns.push_back(i / 8.0);
    expect_near_exact(turns);
    const std::vector<double> halves{0, 0.5, 1, -0.5};
    std::vector<double> cosines(4), sines(4);
    sincos_2pi(halves, cosines, sines);
    EXPECT_EQ(cosines, (std::vector<double>{1, -1, 1, -1}));
    EXPECT_EQ(sines, (std::vector<double>{0, 0, 0, 0}));
}
