// Seams of faces that are narrower than the join distance.
#include "keiko/geometry/seam/seam.h"

#include "tests/support/model_builder.h"
#include "tests/unit/geometry/seam_sides.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using namespace test;

TEST(PairSeams, PassesOverTheFarSideOfASliver) {
    for (const double gap : {0.0, 0.04}) {
        ModelBuilder builder;
        builder.plane({0, 0.3 + gap, 0}, along_x, up_y);
        builder.plane({0, 0, 0}, along_x, {0, 0.3, 0});
        builder.plane({0, 0, 0}, along_x, down_y);
        const auto seams = pair_seams(builder.build(), join);
        ASSERT_EQ(seams.size(), 2u) << gap;
        EXPECT_EQ(seams[0].a.face, 0u);
        EXPECT_EQ(seams[0].b.face, 1u);
        EXPECT_EQ(seams[1].a.face, 1u);
        EXPECT_EQ(seams[1].b.face, 2u);
    }
}

TEST(PairSeams, TellsBordersOfFacesNarrowerThanTheJoinDistanceApart) {
    for (const double width : {0.1, 0.2, 0.42})
        for (const double gap : {0.0, 0.03}) {
            ModelBuilder builder;
            builder.plane({0, 0, 0}, {10, 0, 0}, {0, width, 0});
            builder.plane({0, -gap - width, 0}, {10, 0, 0}, {0, width, 0.3 * width});
            const SurfaceModel model = builder.build();
            const auto seams = pair_seams(model, join);
            ASSERT_EQ(seams.size(), 1u) << width << " " << gap;
            EXPECT_EQ(seams[0].a.curve, natural_side + 0);
            EXPECT_EQ(seams[0].b.curve, natural_side + 2);
        }
}

TEST(PairSeams, PassesOverTheNeighbourBehindTheTipOfANeedle) {
    // Near its tip the needle is narrower than the join distance; a gap of 5 um on one side.
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 2, 0}, up_y);
    builder.patch(1, 1, {{0, 0, 0}, {0, 0, 0}, {100, 0, 0}, {100, 2, 0}});
    builder.plane({0, -0.005, 0}, along_x, down_y);
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 2u);
    EXPECT_EQ(seams[0].a.face, 0u);
    EXPECT_EQ(seams[0].b.face, 1u);
    EXPECT_EQ(seams[1].a.face, 1u);
    EXPECT_EQ(seams[1].b.face, 2u);
}

TEST(PairSeams, KeepsATinyFaceWhoseEdgesAreShorterThanTheJoinDistance) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({20, 0, 0}, {0.2, 0, 0}, {0, -0.1, 0});
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(seams[0].a.begin, 0.2, 1e-12);
    EXPECT_NEAR(seams[0].a.end, 0.202, 1e-12);
}

TEST(PairSeams, DoesNotTakeANarrowFaceForAClosedOne) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, {0, 0.3, 0});
    EXPECT_TRUE(pair_seams(builder.build(), join).empty());
}

} // namespace
} // namespace keiko
