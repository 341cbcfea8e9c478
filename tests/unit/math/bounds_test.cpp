#include "keiko/math/bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace keiko;

TEST(Bounds, DefaultIsEmptyAndContainsNothing) {
    const Box3 box;
    EXPECT_TRUE(box.empty());
    EXPECT_FALSE(box.contains({0, 0, 0}));
    EXPECT_EQ(box.size(), 0);
}

TEST(Bounds, ExtendingByAnEmptyBoxChangesNothing) {
    Box3 box{{0, 0, 0}, {1, 1, 1}};
    box.extend(Box3{});
    EXPECT_EQ(box, (Box3{{0, 0, 0}, {1, 1, 1}}));
}

TEST(Bounds, NanIsNowhereInside) {
    const Box2 box{{0, 0}, {1, 1}};
    EXPECT_FALSE(box.contains({std::nan(""), 0.5}));
    const Box2 broken{{std::nan(""), 0}, {1, 1}};
    EXPECT_TRUE(broken.empty());
}

TEST(Bounds, TouchingBoxesOverlap) {
    EXPECT_TRUE((Box2{{0, 0}, {1, 1}}.overlaps({{1, 1}, {2, 2}})));
    EXPECT_FALSE((Box2{{0, 0}, {1, 1}}.overlaps({{1.0001, 0}, {2, 1}})));
}

TEST(Rounding, FloatsNeverShrinkABox) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> exponent(-300, 300);
    for (int i = 0; i < 100000; ++i) {
        const double x = (i % 2 ? -1 : 1) * std::pow(10, exponent(random) / 8);
        EXPECT_LE(static_cast<double>(round_down(x)), x);
        EXPECT_GE(static_cast<double>(round_up(x)), x);
        EXPECT_LE(std::nextafter(round_down(x), std::numeric_limits<float>::infinity()),
                  std::nextafter(round_up(x), std::numeric_limits<float>::infinity()));
    }
    EXPECT_EQ(round_down(0.5), 0.5f);
    EXPECT_EQ(round_up(0.5), 0.5f);
}
