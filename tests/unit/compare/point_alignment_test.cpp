#include "keiko/compare/scan/point_alignment.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"
#include "keiko/geometry/bezier/bezier.h"

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include "tests/support/random.h"
#include "tests/unit/compare/uneven_sheet.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::ModelBuilder;

ClosestPointQuery query_of(const SurfaceModel& model) {
    return ClosestPointQuery(placed_model(model));
}

/// 100 x 100 mm at height 0, its outside upwards.
SurfaceModel plate() {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {100, 0, 0}, {0, 100, 0});
    return builder.build();
}

/// A turn about a place, then a shift.
Affine motion_about(const Vec3& middle, const Vec3& axis, double degrees, const Vec3& shift) {
    return Affine::translate(middle + shift) * Affine::rotate(axis, degrees_to_radians(degrees)) *
           Affine::translate(-middle);
}

std::vector<Vec3> moved(std::vector<Vec3> points, const Affine& motion) {
    for (Vec3& point : points) point = motion.point(point);
    return points;
}

/// mm that corners of the uneven sheet are off after both motions.
double left_over(const Affine& both) {
    double worst = 0;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(300, 0, 30), Vec3(0, 200, 60), Vec3(300, 200, 90)})
        worst = std::max(worst, (both.point(p) - p).length());
    return worst;
}

/// Expects unit directions that are these axes.
void expect_directions(const std::vector<Vec3>& found, const std::vector<Vec3>& wanted) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT((found[i] - wanted[i]).length(), 1e-6);
}

/// Points of the sheet, each `noise` mm off to one of its sides, every other one to the other.
std::vector<Vec3> points_of_sheet(const ClosestPointQuery& query, double noise) {
    std::vector<Vec3> points;
    for (std::size_t piece = 0; piece < query.piece_count(); ++piece)
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 12; ++j)
                if (const auto at = query.point(piece, Vec2((i + 0.5) / 12, (j + 0.5) / 12)))
                    points.push_back(at->position + at->normal * ((i + j) % 2 ? noise : -noise));
    return points;
}

TEST(AlignPoints, BringsAScanBackOntoTheExactSurface) {
    const ClosestPointQuery query = query_of(test::uneven_sheet());
    const Vec3 middle(150, 100, 20);
    const Affine moved = Affine::translate(middle + Vec3(4, -3, 2)) *
                         Affine::rotate({1, 2, 3}, degrees_to_radians(2)) *
                         Affine::translate(-middle);
    std::vector<Vec3> points = points_of_sheet(query, 0);
    for (Vec3& point : points) point = moved.point(point);
    const PointAlignment found = align_points(points, query);
    EXPECT_TRUE(found.rigid.converged);
    const Affine both = found.rigid.motion * moved;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(300, 0, 30), Vec3(0, 200, 60)})
        EXPECT_LT((both.point(p) - p).length(), 1e-5);
    EXPECT_LT(found.rigid.residual, 1e-6);
}

TEST(AlignPoints, StatesTheNoiseAsItsResidual) {
    const ClosestPointQuery query = query_of(test::uneven_sheet());
    const PointAlignment found =
        align_points(points_of_sheet(query, 0.05), query, {.samples = 1u << 20});
    EXPECT_TRUE(found.rigid.converged);
    EXPECT_NEAR(found.rigid.residual, 0.05, 1e-4);
    EXPECT_LE(found.rigid.residual, 0.05); // where they are, it is that much
}

/// The sheet's polynomial over more than the sheet: points up to `beyond` mm past its borders.
std::vector<Vec3> points_past_sheet(const SurfaceModel& model, double beyond) {
    const BezierPatchView patch = model.patch(0);
    std::vector<Vec3> points;
    for (int i = 0; i < 130; ++i)
        for (int j = 0; j < 90; ++j) {
            const double x = -beyond + (300 + 2 * beyond) * i / 129;
            const double y = -beyond + (200 + 2 * beyond) * j / 89;
            const bool inside = x > 0 && x < 300 && y > 0 && y < 200;
            const Vec3 place = evaluate(patch, Vec2(x / 300, y / 200), 1).position();
            // What lies beyond is another part, which does not continue the sheet.
            points.push_back(inside ? place : place + Vec3(0, 0, 3));
        }
    return points;
}

TEST(AlignPoints, IsNotMovedByAFifthOfThePointsBeyondTheBorders) {
    const SurfaceModel sheet = test::uneven_sheet();
    const ClosestPointQuery query = query_of(sheet);
    const std::vector<Vec3> points = points_past_sheet(sheet, 14);
    const Affine motion = motion_about({150, 100, 20}, {1, 2, 3}, 2, {4, -3, 2});
    const PointAlignment found = align_points(moved(points, motion), query);
    EXPECT_TRUE(found.rigid.converged);
    EXPECT_LT(left_over(found.rigid.motion * motion), 1e-6);
    EXPECT_LT(found.rigid.residual, 1e-6);
    std::size_t inside = 0;
    for (const Vec3& p : points) inside += p.x > 0 && p.x < 300 && p.y > 0 && p.y < 200;
    const double share = static_cast<double>(inside) / static_cast<double>(points.size());
    EXPECT_LT(share, 0.8);
    EXPECT_NEAR(found.used, share, 1e-3);
    EXPECT_TRUE(found.free.empty());
}

TEST(AlignPoints, LeavesADentWhereItIs) {
    const ClosestPointQuery query = query_of(test::uneven_sheet());
    std::vector<Vec3> points = points_of_sheet(query, 0);
    for (Vec3& p : points)
        if (p.x > 180 && p.y > 120) p.z -= 0.5; // a sixth of the sheet
    const Affine motion = motion_about({150, 100, 20}, {1, -1, 0.5}, 1, {1, 2, -1});
    const PointAlignment found = align_points(moved(points, motion), query);
    EXPECT_LT(left_over(found.rigid.motion * motion), 1e-6);
}

TEST(AlignPoints, LeavesAPlaneFreeInItself) {
    const ClosestPointQuery query = query_of(plate());
    std::vector<Vec3> points;
    for (int i = 0; i < 40; ++i)
        for (int j = 0; j < 30; ++j) points.emplace_back(20 + i, 30 + j, 0);
    const Affine motion = motion_about({40, 45, 0}, {1, 2, 3}, 3, {4, -3, 2});
    const std::vector<Vec3> scan = moved(points, motion);
    const PointAlignment found = align_points(scan, query);
    EXPECT_TRUE(found.rigid.converged);
    for (const Vec3& p : scan) EXPECT_NEAR(found.rigid.motion.point(p).z, 0, 1e-9);
    EXPECT_NEAR(found.rigid.shift.x, 0, 1e-9);
    EXPECT_NEAR(found.rigid.shift.y, 0, 1e-9);
    const Vec3 middle = motion.point({39.5, 44.5, 0});
    EXPECT_NEAR(found.rigid.shift.z, -middle.z, 1e-9);
    EXPECT_NEAR(found.rigid.angle * found.rigid.axis.z, 0, 0.02); // tilts alone
    expect_directions(found.free.shifts, {{1, 0, 0}, {0, 1, 0}});
    expect_directions(found.free.turns, {{0, 0, 1}});
}

TEST(AlignPoints, LeavesACylinderFreeAlongAndAboutItsAxis) {
    const ClosestPointQuery query = query_of(test::cylinder_model(Affine::scale(50)));
    std::vector<Vec3> points;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 30; ++j) {
            const double turn = 0.3 + 0.035 * i;
            points.emplace_back(50 * std::cos(turn), 50 * std::sin(turn), -30 + 1.5 * j);
        }
    const Affine motion = motion_about({30, 30, 0}, {1, -2, 3}, 1.5, {2, -1, 3});
    const std::vector<Vec3> scan = moved(points, motion);
    const PointAlignment found = align_points(scan, query);
    EXPECT_TRUE(found.rigid.converged);
    double about = 0;
    for (const Vec3& p : scan) {
        const Vec3 place = found.rigid.motion.point(p);
        EXPECT_NEAR(std::hypot(place.x, place.y), 50, 1e-8);
        about += Vec3(-place.y, place.x, 0).dot(place - p) / 50;
    }
    EXPECT_NEAR(found.rigid.shift.z, 0, 1e-9); // no point went along the axis, on average,
    EXPECT_NEAR(about / static_cast<double>(scan.size()), 0, 1e-9); // and none about it
    expect_directions(found.free.shifts, {{0, 0, 1}});
    expect_directions(found.free.turns, {{0, 0, 1}});
}

TEST(AlignPoints, LeavesASphereFreeToTurn) {
    const ClosestPointQuery query = query_of(test::sphere_model(Affine::scale(50)));
    test::Random random(5);
    std::vector<Vec3> points;
    for (int i = 0; i < 250; ++i) {
        const Vec3 radius = test::random_direction(random) * 50;
        points.push_back(Vec3(3, -2, 1) + radius);
        points.push_back(Vec3(3, -2, 1) - radius);
    }
    const PointAlignment found = align_points(points, query);
    EXPECT_LT((found.rigid.shift - Vec3(-3, 2, -1)).length(), 1e-8);
    EXPECT_LT(found.rigid.angle, 1e-6);
    EXPECT_TRUE(found.free.shifts.empty());
    expect_directions(found.free.turns, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

TEST(AlignPoints, RefusesTooFewPoints) {
    const ClosestPointQuery query = query_of(plate());
    const std::vector<Vec3> few(11, Vec3(50, 50, 1));
    try {
        align_points(few, query);
        FAIL();
    } catch (const FieldError& error) {
        EXPECT_STREQ(error.what(), "points: 11 are too few to align: 12 are needed at least");
    }
}

TEST(AlignPoints, RefusesPointsFarFromTheSurface) {
    const ClosestPointQuery query = query_of(plate());
    std::vector<Vec3> aside; // all of them beyond the border, wherever they are moved
    for (int i = 0; i < 40; ++i) aside.emplace_back(1000.0 * i, 0, 0);
    EXPECT_THROW(align_points(aside, query), FieldError);
}

TEST(AlignPoints, IsTheSameForAnyNumberOfThreads) {
    const SurfaceModel sheet = test::uneven_sheet();
    const ClosestPointQuery query = query_of(sheet);
    const std::vector<Vec3> points =
        moved(points_past_sheet(sheet, 14), motion_about({150, 100, 20}, {1, 2, 3}, 2, {4, 0, 2}));
    EXPECT_EQ(align_points(points, query, {}, {.threads = 1}).rigid.motion,
              align_points(points, query, {}, {.threads = 3}).rigid.motion);
}

} // namespace
} // namespace keiko
