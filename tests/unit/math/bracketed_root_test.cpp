#include "keiko/math/bracketed_root.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

template <class F>
double root_between(const F& f, double a, double b) {
    return bracketed_root(f, {a, f(a)}, {b, f(b)}, 1e-14);
}

TEST(BracketedRoot, IsThatOfTheFunctionInEitherDirection) {
    const auto f = [](double x) { return std::cos(x) - x; };
    constexpr double root = 0.73908513321516064;
    EXPECT_NEAR(root_between(f, 0, 1), root, 1e-14);
    EXPECT_NEAR(root_between(f, 1, 0), root, 1e-14);
    EXPECT_NEAR(root_between([&](double x) { return -f(x); }, 0, 1), root, 1e-14);
}

TEST(BracketedRoot, TakesFewEvaluationsOfASmoothFunction) {
    int count = 0;
    const auto f = [&](double x) {
        ++count;
        return std::exp(x) - 1.3;
    };
    EXPECT_NEAR(root_between(f, 0, 1), std::log(1.3), 1e-14);
    EXPECT_LE(count, 10); // two of them at the ends
}

TEST(BracketedRoot, StaysInItsBracketAtJumpsAndFlatPlaces) {
    const auto inside = [](double x) {
        EXPECT_GE(x, 0);
        EXPECT_LE(x, 1);
    };
    const auto jump = [&](double x) { return inside(x), x < 0.3 ? -1e-9 : 1e9; };
    EXPECT_NEAR(root_between(jump, 0, 1), 0.3, 1e-13);
    const auto flat = [&](double x) { return inside(x), std::pow(x - 0.6, 9); };
    EXPECT_NEAR(root_between(flat, 0, 1), 0.6, 1e-13);
}

TEST(BracketedRoot, IsAnEndWhereTheFunctionVanishesThere) {
    const auto f = [](double x) { return x - 1; };
    EXPECT_EQ(root_between(f, 0, 1), 1);
}

TEST(BracketedRoot, ComesToAnEndWithoutNumbers) {
    const auto f = [](double) { return std::nan(""); };
    const double root = bracketed_root(f, {0, -1}, {1, 1}, 1e-14);
    EXPECT_TRUE(root >= 0 && root <= 1);
}

} // namespace
} // namespace keiko
