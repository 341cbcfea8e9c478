#include "keiko/compare/alignment/closest_point_query.h"

#include "tests/support/model_builder.h"
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
