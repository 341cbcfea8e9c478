#include "keiko/visibility/query/contour_extrema.h"

#include "keiko/visibility/query/visibility_query.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using namespace test;

constexpr double spacing = 0.1;
constexpr double one_place = 1e-5; // of the prism's width

/// A level prism along x over the origin, from slopes -0.5 to 0.5 across and along.
const Prism prism{Segment{Vec3(-500, -500, 1000), Vec3(500, -500, 1000)},
                  {Vec3(-500, 0, 1000), Vec3(500, 0, 1000)},
                  {Vec3(-500, 0, 1000), Vec3(500, 0, 1000)},
                  {Vec3(-500, 500, 1000), Vec3(500, 500, 1000)}};

/// A turn's place by its slope across, y / z, which rises as the angle about the prism falls.
struct Found {
    double slope, missed;
    int dark;
    bool jump;
};

/// By rising slope, seen from the origin.
std::vector<Found> turns_of(const SurfaceModel& model, double missed = 0) {
    const Tracer tracer(model);
    const Occluders occluders(model, tracer);
    std::vector<Vec3> corners;
    for (const Segment& edge : prism) corners.insert(corners.end(), {edge.a, edge.b});
    const VisibilityQuery view(occluders, tracer, Viewpoint::at(Vec3(0)), corners);
    std::vector<Found> found;
    for (const CriticalSlice& turn : view.turns(prism, {spacing, missed})) {
        EXPECT_NEAR(turn.way.x, 0, 1e-12);
        found.push_back({turn.way.y / turn.way.z, turn.missed, turn.dark, turn.jump});
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.slope < b.slope; });
    return found;
}

SurfaceModel parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
    ModelBuilder builder;
    builder.plane(corner, u, v);
    return builder.build();
}

/// Rational biquadratic octants, turned by `axis` from z.
SurfaceModel ball(const Vec3& center, double radius, const Vec3& axis) {
    return sphere_model(stretched(Vec3(radius), axis, center));
}

} // namespace

/// The part that an edge along the prism hides jumps there by as much of the prism as the edge is
/// long.
TEST(ContourExtrema, AreWhereAnEdgeRunsAlong) {
    const std::vector<Found> found =
        turns_of(parallelogram({-60, 40, 400}, {120, 0, 0}, {0, 70, 0}));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].slope, 0.1, one_place);
    EXPECT_NEAR(found[1].slope, 0.275, one_place);
    for (const Found& turn : found) {
        EXPECT_NEAR(turn.missed, 0.3 * spacing / 2, 1e-12);
        EXPECT_TRUE(turn.jump);
    }
    EXPECT_EQ(found[0].dark, -1);
    EXPECT_EQ(found[1].dark, 1);
}

TEST(ContourExtrema, AreAtTheCornersOfAParallelogram) {
    const std::vector<Found> found =
        turns_of(parallelogram({0, 20, 400}, {40, 44, 0}, {-40, 40, 0}));
    ASSERT_EQ(found.size(), 4u);
    EXPECT_NEAR(found[0].slope, 0.05, one_place);
    EXPECT_NEAR(found[1].slope, 0.15, one_place);
    EXPECT_NEAR(found[2].slope, 0.16, one_place);
    EXPECT_NEAR(found[3].slope, 0.26, one_place);
    for (const Found& turn : found) EXPECT_FALSE(turn.jump);
}

/// Only what lies before the prism counts, and an edge beyond both of its ends hides all alike.
TEST(ContourExtrema, AreNowhereBesideThePrism) {
    EXPECT_TRUE(turns_of(parallelogram({300, 40, 400}, {120, 0, 0}, {0, 70, 0})).empty());
    EXPECT_TRUE(turns_of(parallelogram({-60, 240, 400}, {120, 0, 0}, {0, 70, 0})).empty());
    EXPECT_TRUE(turns_of(parallelogram({-60, 40, 1400}, {120, 0, 0}, {0, 70, 0})).empty());
    EXPECT_TRUE(turns_of(parallelogram({-60, -300, 400}, {120, 0, 0}, {0, 600, 0})).empty());
}

TEST(ContourExtrema, LeavesOutAsMuchAsIsAllowed) {
    const SurfaceModel model = parallelogram({-60, 40, 400}, {120, 0, 0}, {0, 70, 0});
    const double of_both = 0.3 * spacing;
    EXPECT_EQ(turns_of(model, 0.45 * of_both).size(), 2u);
    EXPECT_EQ(turns_of(model, 0.55 * of_both).size(), 1u);
    EXPECT_TRUE(turns_of(model, 1.01 * of_both).empty());
}

/// Arcs turn back where they run along, near their middle or far from it.
TEST(ContourExtrema, AreWhereACurvedBorderTurnsBack) {
    constexpr double radius = 60, y = 20, z = 400, eighth = std::numbers::pi / 4;
    for (const double turned : {0.0, 0.11, -0.4, 0.6}) {
        std::vector<Vec4> points;
        for (const double at : {eighth, 2 * eighth, 3 * eighth})
            for (const double r : {radius / 2, radius}) {
                const double w = at == 2 * eighth ? std::cos(eighth) : 1, from_middle = r / w;
                const Vec3 x(from_middle * std::cos(at + turned),
                             y + from_middle * std::sin(at + turned), z);
                points.emplace_back(x.x * w, x.y * w, x.z * w, w);
            }
        ModelBuilder builder;
        builder.rational_patch(2, 1, points);
        const std::vector<Found> found = turns_of(builder.build());
        for (const double r : {radius / 2, radius})
            EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Found& turn) {
                return std::abs(turn.slope - (y + r) / z) < 2 * one_place && turn.missed > 0;
            })) << turned;
        EXPECT_NEAR(found.back().slope, (y + radius) / z, 2 * one_place);
    }
}

/// A border that runs on across, and along a little there and back.
TEST(ContourExtrema, AreWhereABorderBulges) {
    for (const double bulge : {0.2, 1.0, 20.0}) {
        std::vector<Vec3> points;
        for (const double y : {20.0, 40.0, 60.0})
            for (const double x : {0.0, y == 40 ? 10 + bulge : 10.0})
                points.emplace_back(x, y, 400);
        ModelBuilder builder;
        builder.patch(2, 1, points);
        const std::vector<Found> found = turns_of(builder.build());
        EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Found& turn) {
            return std::abs(turn.slope - 0.1) < 2 * one_place && turn.missed > 0;
        })) << bulge;
    }
}

/// A ball's outline turns back where a plane along the prism touches it, wherever its patches meet.
TEST(ContourExtrema, AreWhereABallsOutlineTurnsBack) {
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0.3, 0.5, 0.8), Vec3(-0.7, 0.4, 0.2)})
        for (const Vec3& center : {Vec3(30, -60, 500), Vec3(-90, 70, 450), Vec3(0, 0, 600)}) {
            constexpr double radius = 40;
            const double middle = std::atan2(center.y, center.z),
                         half = std::asin(radius / std::hypot(center.y, center.z));
            const std::vector<Found> found = turns_of(ball(center, radius, axis.normalized()));
            ASSERT_GE(found.size(), 2u);
            EXPECT_NEAR(found.front().slope, std::tan(middle - half), 2 * one_place);
            EXPECT_NEAR(found.back().slope, std::tan(middle + half), 2 * one_place);
            EXPECT_EQ(found.front().dark, -1);
            EXPECT_EQ(found.back().dark, 1);
            for (const Found& turn : found) EXPECT_GT(turn.missed, 0);
        }
}

} // namespace keiko
