// Seams of faces that are narrower than the join distance.
#include "keiko/geometry/seam/seam.h"

#include "tests/support/model_builder.h"
#include "tests/unit/geometry/seam_sides.h"
#include <gtest/gtest.h>

#include <cmath>

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

TEST(PairSeams, KeepsAClosedFaceWhoseEndsOverlap) {
    // A tube of 50 mm in radius, of four arcs that together go round by a little more than once.
    for (const double overlap : {1e-6, 1e-3, 5e-3, 0.05, -5e-3}) {
        const double radius = 50, half = std::acos(-1.0) / 4 + overlap / radius / 8;
        NurbsSurface tube{2, 1, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {0, 0, 1, 1}, {}};
        for (int i = 0; i <= 8; ++i) {
            const double w = i % 2 == 0 ? 1 : std::cos(half), r = radius / w;
            const Vec3 p(r * std::cos(i * half), r * std::sin(i * half), 0);
            for (const double z : {0.0, 100.0}) tube.points.push_back(Vec4(p.x, p.y, z, 1) * w);
        }
        ModelBuilder builder;
        builder.nurbs(tube);
        EXPECT_EQ(pair_seams(builder.build(), join).size(), 1u) << overlap;
    }
}

TEST(PairSeams, DoesNotTakeANarrowFaceForAClosedOne) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, {0, 0.3, 0});
    EXPECT_TRUE(pair_seams(builder.build(), join).empty());
}

} // namespace
} // namespace keiko
