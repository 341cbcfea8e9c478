// Every operation of a batch against that of a double, on every instruction set: the same bits.
#include "tests/support/random.h"
#include "tests/unit/simd/operations.h"
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace keiko;
using namespace keiko::test;

namespace keiko::test {
namespace {

Operations operations_of(SimdLevel level) {
    return KEIKO_AT_LEVEL(level, operations);
}

/// A number of any size, or one of the special ones, or one equal to another of the kind.
double any_number(Random& random) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double special[] = {
        0,        -0.0,      1,      -1,      2.5,   -2.5,
        infinity, -infinity, 5e-324, -5e-324, 1e308, std::numeric_limits<double>::quiet_NaN()};
    const double kind = uniform(random, 0, 1);
    if (kind < 0.4) return special[static_cast<std::size_t>(uniform(random, 0, 11.999))];
    const double size = std::pow(10, uniform(random, -3, kind < 0.5 ? 200 : 3));
    return std::copysign(size, uniform(random, -1, 1));
}

/// The bits of a number; one pattern for all NaN, whose sign the instructions are free to choose.
std::uint64_t bits(double x) {
    return std::bit_cast<std::uint64_t>(std::isnan(x) ? std::numeric_limits<double>::quiet_NaN()
                                                      : x);
}

} // namespace
} // namespace keiko::test

TEST(Batch, ComputesAsADoubleDoesToTheBit) {
    constexpr std::size_t count = 1 << 15;
    Random random(36);
    std::vector<double> a(count), b(count), c(count);
    for (std::size_t i = 0; i < count; ++i)
        a[i] = any_number(random), b[i] = any_number(random), c[i] = any_number(random);
    for (const SimdLevel level : simd_levels()) {
        std::vector<Results> results(count);
        operations_of(level)(a.data(), b.data(), c.data(), count, results.data());
        for (std::size_t i = 0; i < count; ++i)
            compute_all(a[i], b[i], c[i], [&](std::size_t number, double expected) {
                ASSERT_EQ(bits(results[i][number]), bits(expected))
                    << name_of(level) << ", operation " << number << " of " << a[i] << ", " << b[i]
                    << ", " << c[i];
            });
    }
}

TEST(SimdLevels, EndWithTheBaselineAndBeginWithTheWidest) {
    const std::vector<SimdLevel> levels = simd_levels();
    EXPECT_EQ(levels.front(), widest_simd_level());
    EXPECT_EQ(levels.back(), SimdLevel::base);
    for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_GT(levels[i - 1], levels[i]);
}
