#include "keiko/placement/hit_histogram.h"

#include <gtest/gtest.h>

#include <array>

namespace keiko {
namespace {

/// A dense block [2, 4] x [-1, 0] that holds 90 % of the weight, in a thin square [0, 10]^2 - 5.
std::vector<WeightedPlace> block() {
    std::vector<WeightedPlace> places;
    for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j) {
            const Vec2 unit((i + 0.5) / 200, (j + 0.5) / 200);
            places.push_back({Vec2(2, -1) + unit * Vec2(2, 1), 0.9});
            places.push_back({unit * 10.0 - Vec2(5), 0.1});
        }
    return places;
}

TEST(HitHistogram, KeepsTheWholeWeight) {
    const HitHistogram histogram(block(), 100, {Vec2(-5), Vec2(5)});
    double sum = 0;
    for (int v = 0; v < histogram.height(); ++v)
        for (int u = 0; u < histogram.width(); ++u) sum += histogram.at(u, v);
    EXPECT_NEAR(sum, 40000, 1e-6);
    EXPECT_NEAR(histogram.total(), 40000, 1e-6);
    EXPECT_NEAR(histogram.at(0, 0), 0.4, 1e-12);        // 2 x 2 thin places
    EXPECT_NEAR(histogram.at(85, 45), 180 + 0.4, 1e-6); // 10 x 20 dense ones
}

TEST(HitHistogram, SmallestRectangleOfNineTenthsIsTheBlock) {
    constexpr std::array shares{0.97, 0.9};
    const std::vector<Box2> found =
        HitHistogram(block(), 100, {Vec2(-5), Vec2(5)}).rectangles(shares);
    EXPECT_LT((found[1].lower - Vec2(2, -1)).length(), 0.15);
    EXPECT_LT((found[1].upper - Vec2(4, 0)).length(), 0.15);
    EXPECT_GT(found[0].size(), 2 * found[1].size());
}

TEST(HitHistogram, RectanglesHoldTheirShare) {
    const std::vector<WeightedPlace> places = block();
    constexpr std::array shares{0.98, 0.95, 0.9, 0.8, 0.65, 0.3};
    const std::vector<Box2> found = HitHistogram(places, 64).rectangles(shares);
    Box2 before{Vec2(-100), Vec2(100)};
    for (std::size_t i = 0; i < shares.size(); ++i) {
        double held = 0;
        for (const WeightedPlace& p : places) held += found[i].contains(p.place) ? p.weight : 0;
        EXPECT_GE(held / 40000, shares[i] - 1e-9);
        EXPECT_TRUE(before.contains(found[i].lower) && before.contains(found[i].upper));
        before = found[i];
    }
}

TEST(HitHistogram, TheRangeLeavesOutStrays) {
    std::vector<WeightedPlace> places = block();
    places.push_back({Vec2(1e6, -1e6), 1});
    const Box2 range = HitHistogram(places, 10).range();
    EXPECT_LT(range.size(), 30);
    EXPECT_TRUE(range.contains(Vec2(2, -1)) && range.contains(Vec2(4, 0)));
}

TEST(HitHistogram, SmoothingKeepsTheWeightInside) {
    const HitHistogram sharp(std::array{WeightedPlace{Vec2(5.5), 16}}, 11, {Vec2(0), Vec2(11)});
    const HitHistogram smooth = sharp.smoothed();
    EXPECT_EQ(sharp.at(5, 5), 16);
    EXPECT_EQ(smooth.at(5, 5), 4);
    EXPECT_EQ(smooth.at(4, 5), 2);
    EXPECT_EQ(smooth.at(6, 6), 1);
    EXPECT_EQ(smooth.at(7, 5), 0);
}

TEST(HitHistogram, PlacesAllInOneSpotAndNoneAtAllAreFine) {
    const HitHistogram one(std::array{WeightedPlace{Vec2(3, 4), 2}}, 8);
    EXPECT_TRUE(one.range().contains(Vec2(3, 4)));
    EXPECT_EQ(one.total(), 2);
    EXPECT_EQ(HitHistogram(std::span<const WeightedPlace>{}, 8).total(), 0);
}

} // namespace
} // namespace keiko
