#include "keiko/inspect/flaws/reference_form.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keiko {
namespace {

double form(double x, double y) {
    return 0.3 + 0.01 * x - 2e-3 * x * x + 1e-3 * x * y + 3e-8 * x * x * y * y;
}

/// Places within 50 mm, one of four of them in a dent 1 mm deep.
std::vector<FormHeight> dented() {
    test::Random random(4);
    std::vector<FormHeight> heights;
    for (int i = 0; i < 600; ++i) {
        const double x = test::uniform(random, -50, 50), y = test::uniform(random, -50, 50);
        const double r = std::hypot(x - 5, y) / 25;
        heights.push_back({x, y, form(x, y) - (r < 1 ? std::pow(1 - r * r, 4) : 0), 1});
    }
    return heights;
}

TEST(ReferenceForm, IsTheFormUnderADent) {
    const auto base = ReferenceForm::fit(dented(), 50);
    ASSERT_TRUE(base);
    for (const double x : {-30.0, 0.0, 5.0})
        for (const double y : {-20.0, 0.0, 40.0})
            EXPECT_NEAR(base->offset({x, y, form(x, y)}), 0, 1e-6);
}

/// A ball of 100 mm, which no polynomial of degree 4 follows so far, with a dent of 0.05 mm.
TEST(ReferenceForm, FollowsABallWhereItMayBeBent) {
    test::Random random(5);
    std::vector<FormHeight> heights;
    for (int i = 0; i < 600; ++i) {
        const double x = test::uniform(random, -60, 60), y = test::uniform(random, -60, 60);
        const double r = std::hypot(x, y) / 25;
        const double dent = r < 1 ? 0.05 * std::pow(1 - r * r, 3) : 0;
        heights.push_back({x, y, std::sqrt(1e4 - x * x - y * y) - 100 - dent, 1});
    }
    const auto flat = ReferenceForm::fit(heights, 75),
               bent = ReferenceForm::fit(heights, 75, FormKind::bent);
    ASSERT_TRUE(flat && bent);
    EXPECT_GT(flat->origin_bound(), 0.02);
    EXPECT_LT(bent->origin_bound(), 1e-3);
    EXPECT_NEAR(bent->at_origin(), 0, 1e-3);
}

TEST(ReferenceForm, IsNoneOfTooFewPlacesOrOfALine) {
    std::vector<FormHeight> heights = dented();
    heights.resize(25);
    EXPECT_FALSE(ReferenceForm::fit(heights, 50));
    std::vector<FormHeight> line = dented();
    for (FormHeight& h : line) h.y = 0;
    EXPECT_FALSE(ReferenceForm::fit(line, 50));
}

} // namespace
} // namespace keiko
