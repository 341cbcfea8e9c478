#include "keiko/geometry/bernstein/bernstein_field.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

BernsteinField random_field(test::Random& random, int degree_u, int degree_v) {
    std::vector<double> values;
    for (int i = 0; i < (degree_u + 1) * (degree_v + 1); ++i)
        values.push_back(test::uniform(random, -1, 1));
    return {degree_u, degree_v, std::move(values), 0};
}

TEST(BernsteinField, MultipliesAndAddsAsItsValuesDo) {
    test::Random random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const BernsteinField a = random_field(random, 3, 5), b = random_field(random, 4, 2),
                             c = random_field(random, 7, 7);
        const Vec2 uv(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
        EXPECT_NEAR((a * b - c)(uv), a(uv) * b(uv) - c(uv), 1e-14);
        EXPECT_GE((a * b).rounding(), 1e-16);
        EXPECT_TRUE((a * b).range().low <= (a * b)(uv) && (a * b)(uv) <= (a * b).range().high);
    }
}

TEST(BernsteinField, PartsAreTheFieldItself) {
    test::Random random(12);
    const BernsteinField field = random_field(random, 6, 4);
    for (const bool by_u : {true, false}) {
        const auto [low, high] = field.parts(by_u, 0.4);
        for (int i = 0; i < 20; ++i) {
            const Vec2 uv(test::uniform(random, 0, 1), test::uniform(random, 0, 1));
            const Vec2 in_low = by_u ? Vec2(0.4 * uv.x, uv.y) : Vec2(uv.x, 0.4 * uv.y);
            const Vec2 in_high = by_u ? Vec2(0.4 + 0.6 * uv.x, uv.y) : Vec2(uv.x, 0.4 + 0.6 * uv.y);
            EXPECT_NEAR(low(uv), field(in_low), 1e-14);
            EXPECT_NEAR(high(uv), field(in_high), 1e-14);
        }
    }
}

TEST(BernsteinField, DerivativesAreSlopes) {
    test::Random random(13);
    const BernsteinField field = random_field(random, 6, 4);
    const Vec2 uv(0.3, 0.6);
    const double h = 1e-5;
    EXPECT_NEAR(field.derivative(true)(uv),
                (field(uv + Vec2(h, 0)) - field(uv - Vec2(h, 0))) / (2 * h), 1e-7);
    EXPECT_NEAR(field.derivative(false)(uv),
                (field(uv + Vec2(0, h)) - field(uv - Vec2(0, h))) / (2 * h), 1e-7);
}

TEST(BernsteinField, DividesByASideOnWhichItVanishes) {
    test::Random random(14);
    const BernsteinField rest = random_field(random, 3, 4);
    const Vec2 uv(0.3, 0.6);
    const BernsteinField u(1, 0, {0, 1}, 0), not_u(1, 0, {1, 0}, 0), v(0, 1, {0, 1}, 0),
        not_v(0, 1, {1, 0}, 0);
    EXPECT_NEAR((rest * u).without_side(true, false)(uv), rest(uv), 1e-13);
    EXPECT_NEAR((rest * not_u).without_side(true, true)(uv), rest(uv), 1e-13);
    EXPECT_NEAR((rest * v).without_side(false, false)(uv), rest(uv), 1e-13);
    EXPECT_NEAR((rest * not_v).without_side(false, true)(uv), rest(uv), 1e-13);
    EXPECT_LE((rest * u).side_range(true, false).magnitude(), 2 * (rest * u).rounding());
}

} // namespace
} // namespace keiko
