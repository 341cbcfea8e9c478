#include "keiko/geometry/model/patch_grid.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(PatchGrid, FindsThePatchesOfAnAdaptiveSubdivision) {
    // One half of the square whole, the other in two: storage-jar-offset-surfaces.step.
    SurfaceModel model;
    using Kind = ParameterMap::Kind;
    const auto add = [&](double u0, double u1, double v0, double v1) {
        model.patches.push_back({0, 0, 1, 1, {Kind::affine, u0, u1}, {Kind::affine, v0, v1}});
    };
    model.control_points.assign(4, Vec4(0, 0, 0, 1));
    add(0, 0.5, 0, 0.5), add(0, 0.5, 0.5, 1), add(0.5, 1, 0, 1);
    Face face;
    face.patch_count = 3;
    const PatchGrid grid(model, face);
    EXPECT_EQ(grid.locate({0.2, 0.2}, {0, 0}), 0u);
    EXPECT_EQ(grid.locate({0.2, 0.8}, {0, 0}), 1u);
    EXPECT_EQ(grid.locate({0.8, 0.2}, {0, 0}), 2u);
    EXPECT_EQ(grid.locate({0.8, 0.8}, {0, 0}), 2u);
    EXPECT_EQ(grid.locate({0.5, 0.8}, {-1, 0}), 1u); // on the line: by the side of the material
    EXPECT_EQ(grid.locate({0.5, 0.8}, {1, 0}), 2u);
    EXPECT_EQ(grid.locate({0.2, 0.5}, {0, -1}), 0u);
    EXPECT_EQ(grid.locate({7, 0.2}, {0, 0}), 2u); // outside: the nearest
}

} // namespace
} // namespace keiko
