#include "keiko/visibility/boundaries/boundary_piece.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>

using namespace keiko;

// As wide as the tracer's overlaps, which go with the size of what is placed.
TEST(BorderReach, GoesWithTheSizeOfThePlacedFace) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 400, 0});
    builder.instance({});
    builder.instance(Affine::scale(10));
    const SurfaceModel model = builder.build();
    EXPECT_GT(boundary_reach(model, 0, 0), 1e-10 * 400);
    EXPECT_LT(boundary_reach(model, 0, 0), 1e-9 * 400);
    EXPECT_NEAR(boundary_reach(model, 1, 0), 10 * boundary_reach(model, 0, 0), 1e-15);
}

TEST(BorderReach, IsThatOfTheSeamWhereThatIsWider) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.instance(Affine::scale(3));
    const SurfaceModel model = builder.build();
    const Tracer tracer(model);
    const double seam = tracer.seam_width(0), free = boundary_reach(model, 0, 0);
    EXPECT_GE(boundary_reach(model, tracer, 0, 0, 0), std::max(free, 3 * seam));
}
