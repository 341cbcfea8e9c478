#include "keiko/base/units.h"
#include "keiko/light/spotlight/spotlight.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace keiko;

namespace {

double at(const BeamPattern& pattern, double theta, double phi) {
    return pattern_share(pattern, degrees_to_radians(theta), degrees_to_radians(phi));
}

} // namespace

TEST(BeamPattern, PetalsAreBrightAtTheirAxesAndDarkBetween) {
    const Petals petals{6, -0.5};
    for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(at(petals, 10, 60 * i), 1, 1e-12);
        EXPECT_EQ(at(petals, 10, 60 * i + 30), 0);
        EXPECT_NEAR(at(petals, 10, 60 * i + 15), 0.25, 1e-12);
    }
    EXPECT_NEAR(at(Petals{6, 0.4}, 10, 30), 0.4, 1e-12);
}

TEST(BeamPattern, CentredDotsFillEverySecondCell) {
    const Dots dots{.dphi = 30, .dtheta = 4};
    EXPECT_NEAR(at(dots, 2, 45), 1, 1e-12);
    EXPECT_NEAR(at(dots, 6, 15), 1, 1e-12);
    EXPECT_EQ(at(dots, 2, 15), 0);
    EXPECT_EQ(at(dots, 6, 45), 0);
    EXPECT_NEAR(at(dots, 4, 45), 0, 1e-12);
}

TEST(BeamPattern, RoundedDotsLieAboutMultiplesOfThePeriods) {
    const Dots dots{
        .dphi = 30, .dtheta = 4, .q_phi = 0, .q_theta = 0, .reading = DotReading::rounded};
    for (int i = 1; i < 5; ++i)
        for (int j = 1; j < 12; ++j) EXPECT_NEAR(at(dots, 4 * i, 30 * j), (i + j) % 2, 1e-12);
    EXPECT_NEAR(at(dots, 5, 60), 0.5, 1e-12);
    EXPECT_NEAR(at(dots, 3, 60), 0.5, 1e-12); // whole: the same on both sides
}

TEST(BeamPattern, LiteralDotsAreCutThroughTheirMiddle) {
    const Dots dots{
        .dphi = 30, .dtheta = 4, .q_phi = 0, .q_theta = 0, .reading = DotReading::literal};
    EXPECT_EQ(at(dots, 4.01, 31), 0);
    EXPECT_GT(at(dots, 3.99, 31), 0.9);
    EXPECT_GT(at(dots, 4.01, 29), 0.9);
    EXPECT_EQ(at(dots, 3.99, 29), 0);
}

TEST(BeamPattern, MeanOfKAgreesWithOracle) {
    const test::OracleTable table("spot_flux");
    test::WorstError worst("kbar");
    for (const auto& row : table)
        worst.compare(row, mean_of_k(row.number("in.qphi")), row.number("out.kbar"), 1e-13);
}

TEST(BeamPattern, HueAgreesWithOracle) {
    const test::OracleTable table("spot_distribution");
    test::WorstError r("r"), g("g"), b("b"), by_hue("r by hue");
    for (const auto& row : table) {
        const Rgb color = hue_color(degrees_to_radians(row.number("in.phi_deg")));
        const double turn = 2 * std::numbers::pi;
        by_hue.compare(row, hue_color(turn * row.number("out.hue")).r, row.number("out.rgb_r"),
                       1e-11);
        r.compare(row, color.r, row.number("out.rgb_r"), 1e-11);
        g.compare(row, color.g, row.number("out.rgb_g"), 1e-11);
        b.compare(row, color.b, row.number("out.rgb_b"), 1e-11);
    }
}
