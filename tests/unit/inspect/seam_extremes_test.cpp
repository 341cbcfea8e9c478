#include "keiko/inspect/seams/seam_extremes.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

/// A seam 100 mm long along x, to ask for functions of x.
class SeamExtremes : public testing::Test {
protected:
    SeamExtremes() {
        test::flat_sheet(builder_, {0, 50, 0});
        test::flat_sheet(builder_, {0, -50, 0});
        model_ = builder_.build();
    }

    SeamExtreme largest(const std::function<double(double)>& f, double tolerance = 1e-6) const {
        const BoundaryCurves curves(model_);
        const auto seams = pair_seams(model_, 0.5);
        const SeamProbe probe(curves, seams.at(0));
        const SeamQuantity quantity = [&](const SeamPoint& p) { return f(p.place.x); };
        return *seam_extremes(probe, {{quantity, tolerance}}).at(0);
    }

    test::ModelBuilder builder_;
    SurfaceModel model_;
};

TEST_F(SeamExtremes, PolishesASmoothPeak) {
    const SeamExtreme found = largest([](double x) { return 3 - std::pow((x - 41.7) / 10, 2); });
    EXPECT_NEAR(found.value, 3, 1e-14);
    EXPECT_NEAR(found.point.place.x, 41.7, 1e-6);
    EXPECT_LT(found.bound, 1e-6);
}

TEST_F(SeamExtremes, TakesAnEndOfTheSeam) {
    EXPECT_EQ(largest([](double x) { return x; }).value, 100);
    EXPECT_EQ(largest([](double x) { return -x; }).value, 0);
}

TEST_F(SeamExtremes, FindsTheHighestOfManyPeaks) {
    for (const double waves : {0.4, 1.3, 2.9, 4.7, 6.1}) {
        const auto f = [&](double x) {
            return std::sin(2 * std::numbers::pi * waves * x / 100) * (1 + x / 1000);
        };
        double brute = -1;
        for (int i = 0; i <= 200000; ++i) brute = std::max(brute, f(i / 2000.0));
        const SeamExtreme found = largest(f);
        EXPECT_LE(found.value, brute + 1e-6) << waves;
        EXPECT_GE(found.value + found.bound, brute - 1e-9) << waves;
        EXPECT_NEAR(found.value, brute, 1e-6) << waves;
    }
}

TEST_F(SeamExtremes, HandlesAKink) {
    const SeamExtreme found = largest([](double x) { return -std::abs(x - 33.3); });
    EXPECT_NEAR(found.value, 0, 1e-5);
    EXPECT_GE(found.value + found.bound, 0);
}

TEST_F(SeamExtremes, IsNothingWhereTheQuantityIsNeverDefined) {
    const BoundaryCurves curves(model_);
    const auto seams = pair_seams(model_, 0.5);
    const SeamQuantity undefined = [](const SeamPoint&) { return std::nullopt; };
    EXPECT_FALSE(seam_extremes(SeamProbe(curves, seams.at(0)), {{undefined, 1}}).at(0).has_value());
}

} // namespace
} // namespace keiko
