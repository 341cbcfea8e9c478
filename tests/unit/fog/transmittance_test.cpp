#include "keiko/fog/transmittance.h"

#include <gtest/gtest.h>

using namespace keiko;

TEST(Transmittance, IsThatOfTheChannel) {
    const Medium medium{.extinction = {0, 0.1, 1}, .ambient = {5, 6, 7}};
    const Rgb passed = transmittance(medium, 2000);
    EXPECT_EQ(passed.r, 1);
    EXPECT_DOUBLE_EQ(passed.g, std::exp(-0.2));
    EXPECT_DOUBLE_EQ(passed.b, std::exp(-2));
    const Rgb added = ambient_inscatter(medium, 2000);
    EXPECT_EQ(added.r, 0);
    EXPECT_DOUBLE_EQ(added.g, 6 * (1 - std::exp(-0.2)));
}

TEST(Transmittance, MultipliesAlongTheWay) {
    const Medium medium{.extinction = {0.03, 0.1, 0.4}};
    const Rgb a = transmittance(medium, 700), b = transmittance(medium, 4300);
    EXPECT_NEAR((a * b).g, transmittance(medium, 5000).g, 1e-15);
}

TEST(Transmittance, AnInfiniteDepthShowsTheAmbientLight) {
    const Medium medium{.extinction = Rgb(0.1), .ambient = {5, 6, 7}};
    EXPECT_EQ(transmittance(medium, INFINITY), Rgb());
    EXPECT_EQ(ambient_inscatter(medium, INFINITY), Rgb(5, 6, 7));
}
