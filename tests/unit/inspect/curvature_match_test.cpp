#include "keiko/inspect/seams/curvature_match.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

using enum CurvatureFormula;

constexpr double flat_radius = 100e3; ///< mm

TEST(CurvatureMismatch, GivesThePercentagesOfTheCriteriaForRadii100And102) {
    EXPECT_NEAR(curvature_mismatch(alias, 1 / 100.0, 1 / 102.0, flat_radius), 2.0 / 202, 1e-15);
    EXPECT_NEAR(curvature_mismatch(catia, 1 / 100.0, 1 / 102.0, flat_radius), 2.0 / 102, 1e-15);
}

TEST(CurvatureMismatch, DoesNotDependOnTheSideOfTheNormalOrTheOrder) {
    for (const auto formula : {alias, catia}) {
        const double value = curvature_mismatch(formula, 0.01, 0.03, flat_radius);
        EXPECT_EQ(curvature_mismatch(formula, -0.01, -0.03, flat_radius), value);
        EXPECT_EQ(curvature_mismatch(formula, 0.03, 0.01, flat_radius), value);
    }
}

TEST(CurvatureMismatch, IsLargestForAnInflection) {
    EXPECT_EQ(curvature_mismatch(alias, 0.01, -0.01, flat_radius), 1);
    EXPECT_EQ(curvature_mismatch(catia, 0.01, -0.01, flat_radius), 2);
}

TEST(CurvatureMismatch, HasNoStepAtTheFlatRadius) {
    for (const auto formula : {alias, catia})
        for (const double share : {0.0, 0.3, 0.9}) {
            const double below =
                curvature_mismatch(formula, 0.999999e-5, share * 0.999999e-5, flat_radius);
            const double above =
                curvature_mismatch(formula, 1.000001e-5, share * 1.000001e-5, flat_radius);
            EXPECT_NEAR(below, above, 1e-5);
        }
}

TEST(CurvatureMismatch, ComparesAFlatterSurfaceWithTheFlatRadius) {
    EXPECT_NEAR(curvature_mismatch(alias, 2e-6, 0, flat_radius), 0.1, 1e-12);
    EXPECT_NEAR(curvature_mismatch(catia, 2e-6, 0, flat_radius), 0.2, 1e-12);
}

TEST(CurvatureMismatch, VanishesBetweenPlanes) {
    EXPECT_EQ(curvature_mismatch(alias, 0, 0, flat_radius), 0);
    EXPECT_EQ(curvature_mismatch(catia, 0, 0, flat_radius), 0);
    EXPECT_EQ(curvature_mismatch(alias, 0.01, 0, flat_radius), 1);
}

} // namespace
} // namespace keiko
