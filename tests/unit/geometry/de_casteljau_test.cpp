#include "keiko/geometry/bernstein/de_casteljau.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/math/vec.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

#include <vector>

using namespace keiko;
using test::Random;
using test::uniform;

namespace {

std::vector<double> any_coefficients(Random& random, std::size_t count) {
    std::vector<double> c(count);
    for (double& x : c) x = uniform(random, -1, 1);
    return c;
}

/// The polynomial as the sum over Bernstein's.
double sum_over_basis(const std::vector<double>& c, double t) {
    const int degree = static_cast<int>(c.size()) - 1;
    const BernsteinRow row = bernstein_values(degree, t);
    double sum = 0;
    for (std::size_t i = 0; i < c.size(); ++i) sum += c[i] * row[i];
    return sum;
}

} // namespace

TEST(DeCasteljau, EvaluatesTheSumOverBernsteinPolynomials) {
    Random random(3);
    for (std::size_t count = 1; count <= max_degree + 1; ++count) {
        const std::vector<double> c = any_coefficients(random, count);
        for (const double t : {-0.2, 0.0, 0.3, 1.0, 1.1})
            EXPECT_NEAR(bernstein_value(c, t), sum_over_basis(c, t), t < 0 || t > 1 ? 1e-9 : 1e-14)
                << count << ", " << t;
    }
}

TEST(DeCasteljau, PartsAreThePolynomialBeforeAndBeyond) {
    Random random(4);
    for (std::size_t count = 1; count <= 12; ++count) {
        const std::vector<double> c = any_coefficients(random, count);
        for (const double cut : {0.5, 0.2, 0.9}) {
            const auto [before, beyond] = bernstein_parts(c, cut);
            EXPECT_EQ(before.back(), beyond.front());
            for (const double t : {0.0, 0.4, 1.0}) {
                EXPECT_NEAR(bernstein_value(before, t), bernstein_value(c, t * cut), 1e-14);
                EXPECT_NEAR(bernstein_value(beyond, t), bernstein_value(c, cut + t * (1 - cut)),
                            1e-14);
            }
        }
    }
}

TEST(DeCasteljau, TakesControlPointsToo) {
    const std::array<Vec2, 3> arch{Vec2(0, 0), Vec2(1, 2), Vec2(2, 0)};
    EXPECT_EQ(bernstein_value(arch, 0.5), Vec2(1, 1));
    const auto [before, beyond] = bernstein_parts(arch);
    EXPECT_EQ(before[1], Vec2(0.5, 1));
    EXPECT_EQ(beyond[1], Vec2(1.5, 1));
}
