#include "keiko/math/taylor_model.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

double polynomial(const TaylorModel& m, const Vec2& p) {
    const double x = p.x, y = p.y;
    const double terms[] = {1,     x,         y,         x * x,     x * y,
                            y * y, x * x * x, x * x * y, x * y * y, y * y * y};
    double sum = 0;
    for (std::size_t i = 0; i < TaylorModel::count; ++i) sum += m.c[i] * terms[i];
    return sum;
}

/// About `constant`, with terms that shrink with their degree.
TaylorModel random_model(test::Random& random, double constant) {
    TaylorModel m(constant);
    for (std::size_t i = 1; i < TaylorModel::count; ++i)
        m.c[i] = test::uniform(random, -1, 1) * (i < 3 ? 0.2 : i < 6 ? 0.05 : 0.01);
    return m;
}

Vec2 random_place(test::Random& random) {
    return {test::uniform(random, -1, 1), test::uniform(random, -1, 1)};
}

void expect_holds(const TaylorModel& model, const Vec2& place, double value) {
    EXPECT_LE(std::abs(polynomial(model, place) - value), model.error + 1e-14 * std::abs(value));
}

TEST(TaylorModel, HoldsSumsProductsAndRootsEverywhere) {
    test::Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        const TaylorModel a = random_model(random, 2), b = random_model(random, -1);
        const TaylorModel product = a * b, difference = a - b, tripled = a * -3.0;
        const TaylorModel root = sqrt(a), power = inverse_cubed_root(a),
                          nested = sqrt(a * a + b * b), quotient = b / a, negative = a / b;
        for (int sample = 0; sample < 20; ++sample) {
            const Vec2 p = random_place(random);
            const double f = polynomial(a, p), g = polynomial(b, p);
            expect_holds(product, p, f * g);
            expect_holds(difference, p, f - g);
            expect_holds(tripled, p, -3 * f);
            expect_holds(root, p, std::sqrt(f));
            expect_holds(power, p, std::pow(f, -1.5));
            expect_holds(nested, p, std::hypot(f, g));
            expect_holds(quotient, p, g / f);
            expect_holds(negative, p, f / g);
            expect_holds(at_x(product, p.x), {0, p.y}, f * g);
            expect_holds(at_y(product, p.y), {p.x, 0}, f * g);
        }
    }
}

TEST(TaylorModel, IsOffByTheFourthPowerOfTheStep) {
    const auto error_at = [](double step) {
        TaylorModel a(2);
        a.c[1] = step, a.c[2] = -step;
        return std::max({sqrt(a).error, inverse_cubed_root(a).error, (a * a * a * a).error});
    };
    EXPECT_LT(error_at(0.01), 1.1e-4 * error_at(0.1));
    EXPECT_GT(error_at(0.1), 0);
}

TEST(TaylorModel, KnowsNothingOfRootsWhereItMayNotBePositive) {
    TaylorModel a(1);
    a.c[1] = 0.7, a.c[2] = 0.4;
    EXPECT_TRUE(std::isinf(sqrt(a).error));
    EXPECT_TRUE(std::isinf(inverse_cubed_root(a).error));
    EXPECT_TRUE(std::isinf(peak(sqrt(a)).bound));
}

TEST(TaylorModel, MayVanishWhereItDoes) {
    test::Random random(5);
    int vanishing = 0, clear = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const TaylorModel m = random_model(random, test::uniform(random, -0.6, 0.6));
        bool below = false, above = false;
        for (int sample = 0; sample < 100; ++sample)
            (polynomial(m, random_place(random)) < 0 ? below : above) = true;
        if (below && above) ++vanishing;
        if (below && above) {
            EXPECT_TRUE(may_vanish(m));
        }
        if (!may_vanish(m)) ++clear;
    }
    EXPECT_GT(vanishing, 50);
    EXPECT_GT(clear, 50);
    EXPECT_TRUE(may_vanish(sqrt(TaylorModel(-1))));
}

TEST(TaylorPeak, IsAsHighAsTheHighestPlaceOfAQuadratic) {
    test::Random random(3);
    for (int trial = 0; trial < 500; ++trial) {
        TaylorModel m;
        for (std::size_t i = 0; i < 6; ++i) m.c[i] = test::uniform(random, -1, 1);
        double highest = -10;
        constexpr int steps = 100;
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; j <= steps; ++j)
                highest =
                    std::max(highest, polynomial(m, {2.0 * i / steps - 1, 2.0 * j / steps - 1}));
        const TaylorPeak found = peak(m);
        EXPECT_GE(found.bound, highest);
        EXPECT_LT(found.bound, highest + 1e-3);
        EXPECT_NEAR(polynomial(m, found.place), found.bound, 1e-12);
    }
}

TEST(TaylorPeak, IsFoundOnRidgesThatAreNearlyLevel) {
    for (const double fall : {0.0, 1e-14, 1e-9, 1e-5, -1e-9}) {
        TaylorModel m; // -(x + y - 0.3)^2 - fall (x - y)^2
        m.c = {-0.09, 0.6, 0.6, -1 - fall, -2 + 2 * fall, -1 - fall};
        const double exact = std::max(0.0, -fall * 1.7 * 1.7);
        EXPECT_GE(peak(m).bound, exact);
        EXPECT_LT(peak(m).bound, exact + 1e-4);
    }
}

TEST(TaylorPeak, CountsWhatIsNotKnown) {
    test::Random random(11);
    for (int trial = 0; trial < 100; ++trial) {
        TaylorModel m = random_model(random, 0.5);
        m.error = 0.01;
        for (int sample = 0; sample < 50; ++sample)
            EXPECT_GE(peak(m).bound, polynomial(m, random_place(random)) + m.error);
    }
}

} // namespace
} // namespace keiko
