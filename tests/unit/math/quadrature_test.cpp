#include "keiko/math/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace keiko;

TEST(GaussLegendre, IsExactToItsDegree) {
    for (const int order : {1, 2, 3, 8, 16, 33, 64}) {
        const int power = 2 * order - 2; // the highest even power, the odd ones vanish
        const double integral =
            integrate([&](double x) { return std::pow(x, power); }, -1, 1, order);
        EXPECT_NEAR(integral, 2.0 / (power + 1), 4e-15) << "order " << order;
    }
}

TEST(GaussLegendre, WeightsSumToTheLengthAndNodesRise) {
    for (int order = 1; order <= 64; ++order) {
        double sum = 0, last = -1;
        for (const QuadratureNode& node : gauss_legendre(order)) {
            EXPECT_GT(node.x, last);
            last = node.x;
            sum += node.weight;
        }
        EXPECT_LT(last, 1);
        EXPECT_NEAR(sum, 2, 1e-14);
    }
}

TEST(GaussLegendre, ConvergesOnSmoothFunctions) {
    EXPECT_NEAR(integrate([](double x) { return std::exp(x); }, 0, 2, 12), std::expm1(2.0), 1e-14);
}
