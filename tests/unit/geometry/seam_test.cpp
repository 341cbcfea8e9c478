#include "keiko/geometry/seam/seam.h"

#include "keiko/geometry/seam/boundary_curves.h"

#include "tests/support/model_builder.h"
#include "tests/unit/geometry/seam_sides.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using namespace test;

TEST(PairSeams, JoinsTwoBordersAcrossAGap) {
    ModelBuilder builder;
    builder.plane({0, 0.05, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, along_x, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a, (BoundaryInterval{0, 0, natural_side, 0, 1}));
    EXPECT_EQ(seams[0].b, (BoundaryInterval{0, 1, natural_side, 0, 1}));
    EXPECT_FALSE(seams[0].edge.has_value());
}

TEST(PairSeams, LeavesBordersFurtherApartThanTheJoinDistance) {
    ModelBuilder builder;
    builder.plane({0, 0.51, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, along_x, down_y);
    EXPECT_TRUE(pair_seams(builder.build(), join).empty());
    EXPECT_EQ(pair_seams(builder.build(), 0.52).size(), 1u);
}

TEST(PairSeams, RunsBothSidesTheSameWay) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({100, 0, 0}, -along_x, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].b.begin, 1);
    EXPECT_EQ(seams[0].b.end, 0);
    EXPECT_NEAR((begin_of(model, seams[0].a) - begin_of(model, seams[0].b)).length(), 0, 1e-12);
    EXPECT_NEAR((end_of(model, seams[0].a) - end_of(model, seams[0].b)).length(), 0, 1e-12);
}

TEST(PairSeams, SplitsALongBorderAtATJunction) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, {37.25, 0, 0}, down_y);
    builder.plane({37.25, 0, 0}, {62.75, 0, 0}, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 3u);
    EXPECT_EQ(seams[0].a.begin, 0);
    EXPECT_NEAR(seams[0].a.end, 0.3725, 1e-13);
    EXPECT_NEAR(seams[1].a.begin, 0.3725, 1e-13);
    EXPECT_EQ(seams[1].a.end, 1);
    EXPECT_NEAR(length_of(model, seams[2].a), 50, 1e-11); // the two short ones between themselves
}

/// Two planes whose borders run along each other for `contact` mm at their ends, `gap` mm apart.
std::vector<Seam> seams_of_contact(double contact, double gap) {
    ModelBuilder builder;
    builder.plane({0, gap, 0}, along_x, up_y);
    builder.plane({100 - contact, 0, 0}, along_x, down_y);
    return pair_seams(builder.build(), join);
}

TEST(PairSeams, JoinsBordersThatTouchForAFifthOfTheJoinDistance) {
    for (const double contact : {0.11, 0.2, 0.35, 0.49, 0.51, 3.0})
        EXPECT_EQ(seams_of_contact(contact, 0).size(), 1u) << contact;
    EXPECT_TRUE(seams_of_contact(0.09, 0).empty());
    EXPECT_TRUE(seams_of_contact(0.35, 0.02).empty()); // as near as borders come at any corner
    EXPECT_EQ(seams_of_contact(0.51, 0.02).size(), 1u);
}

TEST(PairSeams, DoesNotTakeCrossingOrTouchingBordersForSeams) {
    for (const double degrees : {20.0, 45.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const Vec3 along(std::cos(angle), std::sin(angle), 0);
        ModelBuilder crossing;
        crossing.plane({0, 0, 0}, along_x, up_y);
        crossing.plane(Vec3(50, 0, 0) - along * 30, along * 60, {0, 0, 40});
        EXPECT_TRUE(pair_seams(crossing.build(), join).empty()) << degrees;
        ModelBuilder touching;
        touching.plane({0, 0, 0}, along_x, up_y);
        touching.plane({100, 0, 0}, {along.x * 60, -along.y * 60, 0}, {0, 0, 40});
        EXPECT_TRUE(pair_seams(touching.build(), join).empty()) << degrees;
    }
}

TEST(PairSeams, JoinsAPartToItsMirrorImage) {
    ModelBuilder builder;
    builder.plane({0, 0, 10}, along_x, up_y);
    builder.instance({});
    Affine mirror;
    mirror.rows[1] = Vec3(0, -1, 0);
    builder.instance(mirror);
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a, (BoundaryInterval{0, 0, natural_side, 0, 1}));
    EXPECT_EQ(seams[0].b, (BoundaryInterval{1, 0, natural_side, 0, 1}));
}

TEST(PairSeams, ReportsTheEdgeThatTheFileShares) {
    const auto square = [](std::uint32_t edge, ModelBuilder& builder) {
        builder.loop({{Vec3(0, 0, 1), Vec3(1, 0, 1)},
                      {Vec3(1, 0, 1), Vec3(1, 1, 1)},
                      {Vec3(1, 1, 1), Vec3(0, 1, 1)},
                      {Vec3(0, 1, 1), Vec3(0, 0, 1)}},
                     edge);
    };
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    square(7, builder);
    builder.plane({0, 0, 0}, along_x, down_y);
    square(7, builder);
    builder.plane({0, 50, 0}, along_x, up_y);
    square(8, builder);
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 2u);
    EXPECT_EQ(seams[0].edge, 7u);
    EXPECT_FALSE(seams[1].edge.has_value());
}

TEST(PairSeams, IsTheSameForAnyNumberOfThreads) {
    ModelBuilder builder;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            builder.plane({i * 10.0, j * 10.01, 0}, {10, 0, 0}, {0, 10, 0});
    const SurfaceModel model = builder.build();
    Job one, four;
    one.threads = 1, four.threads = 4;
    const auto seams = pair_seams(model, join, one);
    EXPECT_EQ(seams.size(), 2u * 19 * 20);
    EXPECT_EQ(pair_seams(model, join, four), seams);
}

TEST(PairSeams, ReadsTheWidePatchBesideAKnotSpanOfNoWidth) {
    // tail-section-assembly.step, face 515: the last knot span is 1e-11 of the domain wide.
    NurbsSurface strip{1, 1, {0, 0, 1 - 1e-11, 1, 1}, {0, 0, 1, 1}, {}};
    for (const double x : {0.0, 100 * (1 - 1e-11), 100.0})
        for (const double y : {0.0, 50.0}) strip.points.emplace_back(x, y, 0, 1);
    ModelBuilder builder;
    builder.nurbs(strip);
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.plane({0, 0, 0}, along_x, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(length_of(model, seams[0].a), 100, 1e-6);
    EXPECT_NEAR(BoundaryCurves(model).curve(seams[0].a).at(0.25).position.x, 25, 1e-6);
}

TEST(PairSeams, PassesOverABorderThatIsNoNumber) {
    ModelBuilder builder;
    builder.rational_patch(1, 1, {{0, 0, 0, 0}, {0, 50, 0, 0}, {9, 0, 0, 0}, {9, 50, 0, 0}});
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, along_x, down_y);
    EXPECT_EQ(pair_seams(builder.build(), join).size(), 1u);
}

} // namespace
} // namespace keiko
