#include "keiko/inspect/curvature_match.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

using enum CurvatureFormula;

TEST(CurvatureMismatch, GivesThePercentagesOfTheCriteriaForRadii100And102) {
    EXPECT_NEAR(curvature_mismatch(alias, 1 / 100.0, 1 / 102.0), 2.0 / 202, 1e-15);
    EXPECT_NEAR(curvature_mismatch(catia, 1 / 100.0, 1 / 102.0), 2.0 / 102, 1e-15);
}

TEST(CurvatureMismatch, DoesNotDependOnTheSideOfTheNormalOrTheOrder) {
    for (const auto formula : {alias, catia}) {
        const double value = curvature_mismatch(formula, 0.01, 0.03);
        EXPECT_EQ(curvature_mismatch(formula, -0.01, -0.03), value);
        EXPECT_EQ(curvature_mismatch(formula, 0.03, 0.01), value);
    }
}

TEST(CurvatureMismatch, IsLargestForAnInflection) {
    EXPECT_EQ(curvature_mismatch(alias, 0.01, -0.01), 1);
    EXPECT_EQ(curvature_mismatch(catia, 0.01, -0.01), 2);
}

TEST(CurvatureMismatch, VanishesBetweenPlanes) {
    EXPECT_EQ(curvature_mismatch(alias, 0, 0), 0);
    EXPECT_EQ(curvature_mismatch(catia, 0, 0), 0);
    EXPECT_EQ(curvature_mismatch(alias, 0.01, 0), 1);
}

} // namespace
} // namespace keiko
