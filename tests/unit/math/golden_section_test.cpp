#include "keiko/math/golden_section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

TEST(GoldenSection, FindsTheMinimumOfAParabolaFromAnyPlaceBetweenTheEnds) {
    for (const double minimum : {0.1, 0.37, 0.5, 0.93})
        for (const double first : {0.01, 0.4, 0.99}) {
            const auto f = [&](double x) { return 7 + (x - minimum) * (x - minimum); };
            const FunctionPlace found = golden_section_minimum(f, 0, {first, f(first)}, 1, 1e-7);
            EXPECT_NEAR(found.at, minimum, 1e-7) << first;
            EXPECT_EQ(found.value, f(found.at));
        }
}

TEST(GoldenSection, FindsAKink) {
    const auto f = [](double x) { return std::abs(x - 0.3); };
    EXPECT_NEAR(golden_section_minimum(f, -1, 2, 1e-12).at, 0.3, 1e-12);
}

TEST(GoldenSection, ComesToAnEndWhereTheFunctionIsMonotonic) {
    const auto identity = [](double x) { return x; };
    const auto negated = [](double x) { return -x; };
    EXPECT_NEAR(golden_section_minimum(identity, 2, 5, 1e-9).at, 2, 1e-9);
    EXPECT_NEAR(golden_section_minimum(negated, 2, 5, 1e-9).at, 5, 1e-9);
}

TEST(GoldenSection, NarrowsTheBracketByTheGoldenSectionEachTime) {
    int count = 0;
    const auto f = [&](double x) {
        ++count;
        EXPECT_GT(x, 0);
        EXPECT_LT(x, 1);
        return std::cos(x * 3);
    };
    golden_section_minimum(f, 0, 1, 1e-6);
    EXPECT_EQ(count, 1 + std::ceil(std::log(1e-6) / std::log(1 - golden_section)));
}

TEST(GoldenSection, KeepsTheFirstPlaceOfAPlateau) {
    const auto flat = [](double) { return 1.0; };
    EXPECT_EQ(golden_section_minimum(flat, 0, {0.25, 1}, 1, 1e-3).at, 0.25);
}

} // namespace
} // namespace keiko
