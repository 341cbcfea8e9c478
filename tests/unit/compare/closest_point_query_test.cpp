#include "keiko/compare/alignment/closest_point_query.h"

#include "keiko/compare/alignment/piece_bounds.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/subpatch.h"

#include "tests/support/model_builder.h"
#include "tests/unit/compare/uneven_sheet.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace keiko {
namespace {

using test::ModelBuilder;

/// A quarter of a cylinder of radius 100 about the x axis, x from 0 to 200, from +y to +z: an exact
/// rational patch.
SurfaceModel quarter_cylinder() {
    const double w = std::sqrt(0.5);
    std::vector<Vec4> points;
    for (const double x : {0.0, 200.0})
        for (const auto& [y, z, weight] : {std::array{100.0, 0.0, 1.0}, std::array{100.0, 100.0, w},
                                           std::array{0.0, 100.0, 1.0}})
            points.emplace_back(x * weight, y * weight, z * weight, weight);
    ModelBuilder builder;
    builder.rational_patch(1, 2, points);
    return builder.build();
}

/// 100 x 100 in the plane z = 0 with a square hole from 40 to 60.
SurfaceModel holed_plane() {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.polygon({{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}});
    return builder.build();
}

TEST(ClosestPointQuery, AgreeWithTheDistanceToACylinder) {
    const ClosestPointQuery feet(placed_model(quarter_cylinder()));
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> along(1, 199), angle(0.05, 1.5), radius(40, 300);
    for (int i = 0; i < 2000; ++i) {
        const double x = along(random), a = angle(random), r = radius(random);
        const Vec3 p(x, r * std::cos(a), r * std::sin(a));
        const ClosestSurfacePoint foot = feet.foot(p);
        EXPECT_NEAR(foot.distance, std::abs(r - 100), 1e-10);
        EXPECT_LT((foot.position - Vec3(x, 100 * std::cos(a), 100 * std::sin(a))).length(), 1e-9);
        EXPECT_FALSE(foot.on_border);
        if (std::abs(r - 100) < 50) {
            EXPECT_TRUE(foot.certain(1e-9)) << "r = " << r;
        }
        EXPECT_LE(foot.nearest, foot.distance);
        EXPECT_NEAR(std::abs(foot.normal.dot(Vec3(0, std::cos(a), std::sin(a)))), 1, 1e-12);
    }
}

TEST(ClosestPointQuery, TakeTheBorderWhereTheNearestSurfaceIsTrimmedAway) {
    const ClosestPointQuery feet(placed_model(holed_plane()));
    const ClosestSurfacePoint over_hole = feet.foot({45, 50, 12});
    EXPECT_NEAR(over_hole.distance, 13, 1e-10); // 5 aside, 12 above
    EXPECT_TRUE(over_hole.on_border);
    EXPECT_FALSE(over_hole.certain(0.5));
    EXPECT_NEAR(over_hole.nearest, 12, 1e-10); // of the plane through the hole
    const ClosestSurfacePoint beside = feet.foot({20, 20, 12});
    EXPECT_NEAR(beside.distance, 12, 1e-12);
    EXPECT_TRUE(beside.certain(1e-12));
    EXPECT_NEAR(feet.foot({103, 50, 4}).distance, 5, 1e-10);
}

TEST(ClosestPointQuery, TellsTheDistanceToBorders) {
    const ClosestPointQuery feet(placed_model(holed_plane()));
    EXPECT_NEAR(feet.border_distance({37, 50, 0}), 3, 1e-10);
    EXPECT_NEAR(feet.border_distance({100, 110, 0}), 10, 1e-10);
}

TEST(ClosestPointQuery, FindsEveryPointOfTheBodyOnIt) {
    SurfaceModel model = quarter_cylinder();
    model.instances[0].transform = Affine::translate({1e4, -3e3, 500}) * Affine::scale(2);
    const PlacedModel placed = placed_model(model);
    const ClosestPointQuery feet(placed_model(model));
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            const Vec3 p = evaluate(placed.model.patch(0), {i / 20.0, j / 20.0}, 0).position();
            EXPECT_LT(feet.foot(p).distance, 1e-9);
        }
}

/// Random places up to 80 mm off the uneven sheet.
std::vector<Vec3> places_about_sheet(int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> x(-40, 340), y(-40, 240), z(-80, 180);
    std::vector<Vec3> places;
    for (int i = 0; i < count; ++i) places.emplace_back(x(random), y(random), z(random));
    return places;
}

TEST(ClosestPointQuery, FindsNothingFartherThanAnySample) {
    const SurfaceModel sheet = test::uneven_sheet();
    const ClosestPointQuery query(placed_model(sheet));
    std::vector<Vec3> samples;
    for (int i = 0; i <= 200; ++i)
        for (int j = 0; j <= 200; ++j)
            samples.push_back(evaluate(sheet.patch(0), Vec2(i / 200.0, j / 200.0), 0).position());
    for (const Vec3& p : places_about_sheet(300)) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& sample : samples) least = std::min(least, (sample - p).length());
        const ClosestSurfacePoint foot = query.foot(p);
        EXPECT_LE(foot.distance, least + 1e-9);
        EXPECT_LE(foot.nearest, foot.distance);
        EXPECT_GT(foot.distance, least - 1.5); // the samples are 1.5 mm apart
    }
}

TEST(ClosestPointQuery, FindsTheSameWhereverASearchBegins) {
    const ClosestPointQuery query(placed_model(test::uneven_sheet()));
    ClosestSurfacePoint last = query.foot(Vec3(0));
    for (const Vec3& p : places_about_sheet(1000)) {
        const ClosestSurfacePoint alone = query.foot(p);
        const auto found = query.foot_from(last, p, 500);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->distance, alone.distance, 1e-9);
        EXPECT_EQ(found->certain(1e-6), alone.certain(1e-6));
        last = *found;
    }
}

TEST(PieceBounds, AreNotNearerThanThePieceNorProveAnother) {
    const SurfaceModel sheet = test::uneven_sheet();
    const std::vector<Vec4> part = subpatch(sheet.patch(0), {Vec2(0.25, 0.5), Vec2(0.5, 0.75)});
    const BezierPatchView piece{3, 3, part};
    const PieceBounds bounds(sub_patch_frame(piece));
    int proved = 0, denied = 0;
    for (const Vec3& p : places_about_sheet(2000)) {
        const PieceProjection foot = piece_projection(piece, p);
        EXPECT_LE(bounds.nearest(p), foot.distance + 1e-9);
        if (!bounds.proves(p - foot.position)) {
            ++denied;
            continue;
        }
        ++proved;
        for (int i = 0; i <= 16; ++i)
            for (int j = 0; j <= 16; ++j) {
                const Vec3 other = evaluate(piece, Vec2(i / 16.0, j / 16.0), 0).position();
                EXPECT_GE((other - p).length(), foot.distance - 1e-9);
            }
    }
    EXPECT_GT(proved, 500);
    EXPECT_GT(denied, 10); // farther than the centres of curvature
}

TEST(PlacedModel, KeepsTheOutsideOutsideInAMirror) {
    SurfaceModel model = quarter_cylinder();
    model.instances.push_back({0, "", {{Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}, Vec3(0)}});
    const PlacedModel placed = placed_model(model);
    ASSERT_EQ(placed.model.faces.size(), 2u);
    EXPECT_EQ(placed.origin[1], (PlacedFace{1, 0}));
    const ClosestPointQuery feet(placed_model(model));
    const Vec3 right = feet.foot({50, 80, 80}).normal, left = feet.foot({-50, 80, 80}).normal;
    EXPECT_LT((right - left).length(), 1e-12);
}

} // namespace
} // namespace keiko
