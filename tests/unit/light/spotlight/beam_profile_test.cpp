#include "keiko/light/spotlight/spotlight.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;

namespace {

constexpr double all_around = 2; // the rim of a beam of 180 degrees

double share(const BeamProfile& profile, double versine, double rim) {
    return profile_share(profile, {.versine = versine}, 0, rim);
}

} // namespace

TEST(BeamProfile, TheRimBelongsToTheBeam) {
    const double rim = 1 - std::cos(0.5);
    const EdgeProfile sharp{BeamEdge::sharp}, mixed{BeamEdge::mixed, 0.25};
    EXPECT_EQ(share(sharp, rim, rim), 1);
    EXPECT_EQ(share(sharp, std::nextafter(rim, 1), rim), 0);
    EXPECT_EQ(share(mixed, rim, rim), 0.25);
    EXPECT_EQ(share(mixed, 0, rim), 1);
}

TEST(BeamProfile, WideSoftBeamsAreLambertAndCardioid) {
    EXPECT_NEAR(share(EdgeProfile{}, 1 - 0.3, 1), 0.3, 1e-15);
    EXPECT_NEAR(share(EdgeProfile{}, 1 + 0.3, all_around), (1 - 0.3) / 2, 1e-15);
}

TEST(BeamProfile, WarnsPowerIsDarkBehindTheLamp) {
    EXPECT_NEAR(share(CosinePower{3}, 0.5, all_around), 0.125, 1e-15);
    EXPECT_EQ(share(CosinePower{2}, 1.5, all_around), 0);
    EXPECT_EQ(share(CosinePower{0}, 1, all_around), 0);
}

TEST(BeamProfile, PolynomialsAreNeverNegative) {
    const CosinePolynomial polynomial{{-0.5, 0, 2}};
    EXPECT_NEAR(share(polynomial, 0, all_around), 1.5, 1e-15);
    EXPECT_NEAR(share(polynomial, 1.8, all_around), -0.5 + 2 * 0.64, 1e-14);
    EXPECT_EQ(share(polynomial, 1, all_around), 0);
    EXPECT_EQ(polynomial_value({}, 1), 0);
}
