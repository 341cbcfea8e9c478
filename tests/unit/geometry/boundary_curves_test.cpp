#include "keiko/geometry/seam/boundary_curves.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::ModelBuilder;

TEST(BoundaryCurves, PointsInwardsAtOuterBordersAndAtHoles) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}});                 // clockwise on purpose
    builder.polygon({{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}); // anticlockwise hole
    const SurfaceModel model = builder.build();
    const BoundaryCurves curves(model);
    const auto inward = [&](std::uint32_t curve) {
        return curves.curve({0, 0, curve, 0, 1}).frame(0.5)->inward;
    };
    EXPECT_NEAR(inward(0).x, 1, 1e-15); // u = 0
    EXPECT_NEAR(inward(2).x, -1, 1e-15);
    EXPECT_NEAR(inward(4).y, -1, 1e-15); // the hole's lower side
    EXPECT_NEAR(inward(6).y, 1, 1e-15);
}

} // namespace
} // namespace keiko
