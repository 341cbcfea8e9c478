#include "keiko/patch/seam.h"

#include "keiko/patch/boundary_curves.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder;

constexpr double join = 0.5;
const Vec3 along_x(100, 0, 0), up_y(0, 50, 0), down_y(0, -50, 0);

double length_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).length(i.begin, i.end);
}

Vec3 begin_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).at(i.begin).position;
}

Vec3 end_of(const SurfaceModel& model, const BoundaryInterval& i) {
    return BoundaryCurves(model).curve(i).at(i.end).position;
}

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

TEST(PairSeams, FindsTheExactEndsOfAPartialOverlap) {
    ModelBuilder builder;
    builder.plane({0, 0.02, 0}, along_x, up_y);
    builder.plane({-40, 0, 0}, along_x, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a.begin, 0);
    EXPECT_NEAR(seams[0].a.end, 0.6, 1e-12);
    EXPECT_NEAR(seams[0].b.begin, 0.4, 1e-12);
    EXPECT_EQ(seams[0].b.end, 1);
}

TEST(PairSeams, EndsAWedgeWhereItOpensPastTheJoinDistance) {
    const double angle = 0.01;
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, {100 * std::cos(angle), -100 * std::sin(angle), 0}, down_y);
    const auto seams = pair_seams(builder.build(), join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(seams[0].a.end, join / std::sin(angle) / 100, 1e-9);
}

/// Shares its corners at x = 0 and x = 100 with a border along x and bows away by `bow` mm between.
std::vector<Vec3> bowed_sheet(double bow) {
    return {{0, 0, 0}, {50, -2 * bow, 0}, {100, 0, 0}, {0, -50, 0}, {50, -50, 0}, {100, -50, 0}};
}

TEST(PairSeams, FindsTheClosedEndOfASeamThatGapesOpen) {
    for (const double opening : {2.2, 5.0, 10.0}) {
        const Vec3 away(100, 0, opening);
        const double length = join / std::sin(std::atan(opening / 100));
        for (const bool backwards : {false, true}) {
            ModelBuilder builder;
            builder.plane({0, 0, 0}, along_x, up_y);
            backwards ? builder.plane(away, -away, down_y) : builder.plane({0, 0, 0}, away, down_y);
            const SurfaceModel model = builder.build();
            const auto seams = pair_seams(model, join);
            ASSERT_EQ(seams.size(), 1u) << opening << backwards;
            EXPECT_EQ(seams[0].a.begin, 0);
            EXPECT_NEAR(length_of(model, seams[0].b), length, length * 0.01);
            EXPECT_EQ(seams[0].b.begin, backwards ? 1 : 0);
        }
    }
}

TEST(PairSeams, FindsBothClosedEndsOfABowedBorder) {
    for (const double bow : {0.6, 1.0, 3.0}) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, along_x, up_y);
        builder.patch(1, 2, bowed_sheet(bow));
        const SurfaceModel model = builder.build();
        const auto seams = pair_seams(model, join);
        ASSERT_EQ(seams.size(), 2u) << bow;
        const double end = (1 - std::sqrt(1 - join / bow)) / 2; // 4 bow x (1 - x) = join
        EXPECT_EQ(seams[0].a.begin, 0);
        EXPECT_NEAR(seams[0].a.end, end, 0.01 * end);
        EXPECT_NEAR((end_of(model, seams[0].a) - end_of(model, seams[0].b)).length(), join, 1e-9);
        EXPECT_NEAR(seams[1].a.begin, 1 - end, 0.01 * end);
        EXPECT_EQ(seams[1].a.end, 1);
    }
}

TEST(PairSeams, PartsBordersWhereThePartnerBowsAwayBetweenLooks) {
    // The bowed border comes first, so that it is the straight one that is looked at.
    ModelBuilder builder;
    builder.patch(1, 2, bowed_sheet(1));
    builder.plane({0, 0, 0}, along_x, up_y);
    EXPECT_EQ(pair_seams(builder.build(), join).size(), 2u);
}

TEST(PairSeams, FindsBordersThatComeNearBetweenTheirEnds) {
    // They cross in a place where no polyline has a corner.
    const double slope = 0.06, cross = 36;
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, -cross * slope}, {100, 0, 100 * slope}, down_y);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(begin_of(model, seams[0].a).x, cross - join / slope, 0.05);
    EXPECT_NEAR(end_of(model, seams[0].a).x, cross + join / slope, 0.05);
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

/// Covers x in [0, 10] and y from 0 to 5; its border at y = 0 is cut into equal pieces.
std::vector<Vec2> cut_rectangle(int pieces) {
    std::vector<Vec2> corners;
    for (int i = 0; i <= pieces; ++i) corners.emplace_back(static_cast<double>(i) / pieces, 0);
    corners.emplace_back(1, 1);
    corners.emplace_back(0, 1);
    return corners;
}

TEST(PairSeams, DoNotDependOnHowBordersAreCut) {
    // 4 times the gap is more than a piece is long, and pieces end in the middle of others.
    const double gap = 0.05;
    for (const auto& [upper, lower] : {std::pair(1, 200), std::pair(200, 3), std::pair(130, 170)}) {
        ModelBuilder builder;
        builder.plane({0, gap, 0}, {10, 0, 0}, {0, 5, 0});
        builder.polygon(cut_rectangle(upper));
        builder.plane({0, 0, 0}, {10, 0, 0}, {0, -5, 0});
        builder.polygon(cut_rectangle(lower));
        const SurfaceModel model = builder.build();
        double length = 0;
        for (const Seam& seam : pair_seams(model, join)) length += length_of(model, seam.a);
        EXPECT_NEAR(length, 10, 1e-9) << upper << " and " << lower;
    }
}

TEST(PairSeams, LeaveAScrapAtOneEndOfASeam) {
    // Beyond x = 10 the lower border turns away by 9 degrees; the upper one ends 0.3 mm later.
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {10.3, 0, 0}, {0, 5, 0});
    const double away = 10 * std::tan(9 * std::numbers::pi / 180);
    builder.plane({0, -10, 0}, {20, 0, 0}, {0, 10, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1 - away / 10}, {0.5, 1}, {0, 1}});
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(length_of(model, seams[0].a), 10, 1e-9);
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

const double half_root = std::sqrt(0.5);

/// A quarter of a cylinder about z, in u from `from` quarter turns, in v along z.
std::vector<Vec4> quarter_cylinder(double radius, double height, int from) {
    const auto at = [&](double x, double y, double z, double w) {
        const int turns = from % 4;
        for (int i = 0; i < turns; ++i) std::swap(x, y), x = -x;
        return Vec4(radius * x * w, radius * y * w, z * w, w);
    };
    return {at(1, 0, 0, 1),         at(1, 0, height, 1),
            at(1, 1, 0, half_root), at(1, 1, height, half_root),
            at(0, 1, 0, 1),         at(0, 1, height, 1)};
}

TEST(PairSeams, JoinsAClosedFaceToItself) {
    // Four knot spans of one face: the natural side at u lowest meets the one at u highest.
    NurbsSurface tube{2, 1, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {0, 0, 1, 1}, {}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const auto points = quarter_cylinder(30, 80, quarter);
        tube.points.insert(tube.points.end(), points.begin() + (quarter == 0 ? 0 : 2),
                           points.end());
    }
    ModelBuilder builder;
    builder.nurbs(tube);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].a.face, seams[0].b.face);
    EXPECT_NEAR(length_of(model, seams[0].a), 80, 1e-10);
}

// Both ends of each border face both ends of the other.
TEST(PairSeams, JoinsATorusToItselfAllAround) {
    for (const double size : {1e-2, 1.0, 1e3}) {
        const SurfaceModel model = test::torus_model(60 * size, 20 * size, 0.3);
        double length = 0;
        for (const Seam& seam : pair_seams(model, size < 1 ? 0.01 : join)) {
            EXPECT_NEAR(length_of(model, seam.a), length_of(model, seam.b), 1e-9 * size);
            length += length_of(model, seam.a) / size;
        }
        const double pi = std::numbers::pi;
        EXPECT_NEAR(length, 2 * pi * (60 + 20 * std::cos(0.3) + 20), 1e-6) << size;
    }
}

TEST(PairSeams, DoesNotTakeANarrowFaceForAClosedOne) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, along_x, {0, 0.3, 0});
    EXPECT_TRUE(pair_seams(builder.build(), join).empty());
}

TEST(PairSeams, JoinsBordersOfDifferentParametrisation) {
    // The rim of a quarter cylinder against the same arc, trimmed out of a plane by a p-curve.
    ModelBuilder builder;
    builder.rational_patch(2, 1, quarter_cylinder(30, 80, 0));
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    const double r = 0.3;
    builder.loop({{Vec3(0, 0, 1), Vec3(r, 0, 1)},
                  {Vec3(r, 0, 1), Vec3(r, r, 1) * half_root, Vec3(0, r, 1)},
                  {Vec3(0, r, 1), Vec3(0, 0, 1)}});
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_EQ(seams[0].b, (BoundaryInterval{0, 1, 1, 0, 1}));
    EXPECT_NEAR(length_of(model, seams[0].a), 15 * std::numbers::pi, 1e-9);
}

TEST(PairSeams, SkipsBordersThatArePoints) {
    // Two octants of a sphere: they share a meridian and, as a point, the pole.
    const double w = half_root;
    const std::vector<Vec4> octant{{10, 0, 0, 1},
                                   {10 * w, 0, 10 * w, w},
                                   {0, 0, 10, 1},
                                   {10 * w, 10 * w, 0, w},
                                   {10 * w * w, 10 * w * w, 10 * w * w, w * w},
                                   {0, 0, 10 * w, w},
                                   {0, 10, 0, 1},
                                   {0, 10 * w, 10 * w, w},
                                   {0, 0, 10, 1}};
    std::vector<Vec4> next = octant;
    for (Vec4& p : next) p = Vec4(-p.y, p.x, p.z, p.w);
    ModelBuilder builder;
    builder.rational_patch(2, 2, octant);
    builder.rational_patch(2, 2, next);
    const SurfaceModel model = builder.build();
    const auto seams = pair_seams(model, join);
    ASSERT_EQ(seams.size(), 1u);
    EXPECT_NEAR(length_of(model, seams[0].a), 5 * std::numbers::pi, 1e-9);
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

TEST(PairSeams, PassesOverABorderThatIsNoNumber) {
    ModelBuilder builder;
    builder.rational_patch(1, 1, {{0, 0, 0, 0}, {0, 50, 0, 0}, {9, 0, 0, 0}, {9, 50, 0, 0}});
    builder.plane({0, 0, 0}, along_x, up_y);
    builder.plane({0, 0, 0}, along_x, down_y);
    EXPECT_EQ(pair_seams(builder.build(), join).size(), 1u);
}

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
