#include "keiko/light/luminance/elevations.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(Elevations, AreThoseAboveTheHorizon) {
    test::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const double al = test::uniform(random, -1, 1), nz = test::uniform(random, -1, 1);
        const ParameterInterval lit = above_horizon(al, nz, {-1, 1});
        const double t = test::uniform(random, -1, 1), eta = 2 * std::atan(t);
        const double height = al * std::cos(eta) + nz * std::sin(eta);
        const bool is_lit = t > lit.begin && t < lit.end;
        if (std::abs(height) > 1e-9) {
            EXPECT_EQ(is_lit, height > 0) << al;
        }
    }
}

/// A lamp that stands upright on the horizon to within rounding is lit from its foot to its end.
TEST(Elevations, OfUprightLinesSurviveRounding) {
    for (const double al : {1e-17, -1e-17, 1e-300, 0.0}) {
        const ParameterInterval up = above_horizon(al, 1, {-0.5, 0.75});
        EXPECT_NEAR(up.begin, 0, 1e-16);
        EXPECT_EQ(up.end, 0.75);
        const ParameterInterval down = above_horizon(al, -1, {-0.5, 0.75});
        EXPECT_EQ(down.begin, -0.5);
        EXPECT_NEAR(down.end, 0, 1e-16);
    }
}

} // namespace
} // namespace keiko
