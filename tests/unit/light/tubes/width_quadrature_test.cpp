#include "keiko/light/tubes/tube_slices.h"

#include <gtest/gtest.h>

#include <numbers>

using namespace keiko;

TEST(AcrossRule, KeepsTheWidthAndTheMeanOfTheRims) {
    for (const int nodes : {1, 2, 4}) {
        ASSERT_EQ(width_quadrature(nodes).size(), static_cast<std::size_t>(nodes));
        double width = 0, rims = 0, square = 0;
        for (const AcrossNode& node : width_quadrature(nodes)) {
            width += node.weight;
            rims += node.weight * node.rim;
            square += node.weight * node.x * node.x;
        }
        EXPECT_NEAR(width, 2, 1e-15);
        EXPECT_NEAR(rims, std::numbers::pi / 2, 1e-15) << "half of the unit circle";
        EXPECT_NEAR(square, nodes == 1 ? 0 : 2.0 / 3, 1e-15);
    }
}
