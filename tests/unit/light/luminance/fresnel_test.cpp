#include "keiko/light/luminance/fresnel.h"

#include "keiko/base/units.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/math/quadrature.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

TEST(Fresnel, AgreesWithAmplitudesOfTheOracle) {
    const test::OracleTable table("fresnel");
    test::WorstError worst("R");
    for (const auto& row : table) {
        const double c = std::cos(degrees_to_radians(row.number("in.theta_deg")));
        const double n = row.number("in.n");
        const double r = row.text("in.kind") == "dielectric"
                             ? fresnel_dielectric(c, n)
                             : fresnel_conductor(c, n, row.number("in.k"));
        worst.compare(row, r, row.number("out.R"), 1e-11);
    }
}

TEST(Fresnel, MeanAgreesWithOracle) {
    const test::OracleTable table("fresnel_mean");
    test::WorstError outside("Fbar_ext"), inside("Fbar_int");
    for (const auto& row : table) {
        const double n = row.number("in.n");
        outside.compare(row, fresnel_mean(n), row.number("out.Fbar_ext"), 1e-11);
        inside.compare(row, fresnel_mean(1 / n), row.number("out.Fbar_int"), 1e-11);
    }
}

TEST(Fresnel, MeanIsContinuousWhereItsFormulaChanges) {
    const double below = fresnel_mean(std::nextafter(1.2, 0)), above = fresnel_mean(1.2);
    EXPECT_NEAR(below, above, 1e-12);
}

TEST(Fresnel, MeanOfAVanishingBorderVanishes) {
    EXPECT_EQ(fresnel_mean(1), 0);
    EXPECT_GT(fresnel_mean(1 + 1e-9), 0);
    EXPECT_LT(fresnel_mean(1 + 1e-9), 1e-8);
    EXPECT_LT(fresnel_mean(1.001), fresnel_mean(1.002));
}

TEST(Fresnel, GrazingLightIsMirroredWhole) {
    EXPECT_DOUBLE_EQ(fresnel_dielectric(0, 1.5), 1);
    EXPECT_DOUBLE_EQ(fresnel_conductor(0, 0.2, 3.4), 1);
    EXPECT_EQ(fresnel_dielectric(0.1, 1 / 1.5), 1);
}

TEST(ClearCoat, AlbedoAgreesWithOracle) {
    const test::OracleTable table("fresnel_mean");
    test::WorstError worst("coat_albedo");
    for (const auto& row : table) {
        const ClearCoat coat(Rgb(row.number("in.rho")), row.number("in.n"));
        const double c = std::cos(degrees_to_radians(row.number("in.thetav_deg")));
        const double albedo = coat.mirrored(c) + coat.base_reflectance_diffuse(c).g;
        worst.compare(row, albedo, row.number("out.coat_albedo"), 1e-11);
    }
}

TEST(ClearCoat, IsTheBaseItselfWithoutABorder) {
    const ClearCoat coat(Rgb(0.1, 0.5, 1), 1);
    EXPECT_EQ(coat.mirrored(0.7), 0);
    EXPECT_EQ(coat.base_reflectance(0.7, 0.3), Rgb(0.1, 0.5, 1));
}

TEST(ClearCoat, DiffuseReflectanceIsTheMeanOverTheLight) {
    const ClearCoat coat(Rgb(0.4), 1.5);
    const double mean = integrate(
        [&](double root) { // c = root^2 tames the knee at grazing incidence
            const double c = root * root;
            return 4 * c * root * coat.base_reflectance(0.8, c).g;
        },
        0, 1, 64);
    EXPECT_NEAR(coat.base_reflectance_diffuse(0.8).g, mean, 1e-9);
}
