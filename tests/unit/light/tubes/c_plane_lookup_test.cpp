#include "keiko/light/tubes/c_plane_lookup.h"

#include "keiko/light/tubes/tube_hit.h"
#include "keiko/light/tubes/tube_lamp.h"

#include "tests/support/random.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

const CPlane ceiling{.origin = {-500, -600, 2000},
                     .u = {1000, 0, 0},
                     .v = {0, 1200, 0},
                     .lamps = 12,
                     .diameter = 40,
                     .luminance = {1000, 2000, 3000}};
const CPlaneFrame frame(ceiling);

/// The mean over a pixel of what its rays see one by one.
double mean_of_points(const Vec3& origin, const Vec3& direction, const RayDifferentials& spread,
                      MirrorModel look) {
    const int side = 700;
    int lit = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const double x = (i + 0.5) / side - 0.5, y = (j + 0.5) / side - 0.5;
            const Vec3 o = origin + spread.origin_dx * x + spread.origin_dy * y;
            const Vec3 d = direction + spread.direction_dx * x + spread.direction_dy * y;
            lit += look_up(frame, o, d, {}, look).coverage > 0;
        }
    }
    return lit / static_cast<double>(side * side);
}

/// A pixel of `mm` on the plane, turned against the lamps by the angle with that sine.
RayDifferentials pixel_of(double mm, double sine) {
    const double s = sine * mm / 2000, c = std::sqrt(1 - sine * sine) * mm / 2000;
    return {Vec3(0), Vec3(0), Vec3(c, s, 0), Vec3(-s, c, 0)};
}

} // namespace

TEST(CPlaneFrame, MakesVOrthogonalAndCentresTheComb) {
    const CPlaneFrame skewed({.origin = {1, 2, 3},
                              .u = {200, 0, 0},
                              .v = {50, 300, 0},
                              .lamps = 2,
                              .pitch = 100,
                              .diameter = 20});
    EXPECT_EQ(skewed.u, Vec3(1, 0, 0));
    EXPECT_NEAR((skewed.v - Vec3(0, 1, 0)).length(), 0, 1e-15);
    EXPECT_DOUBLE_EQ(skewed.axis(0), 100);
    EXPECT_DOUBLE_EQ(skewed.axis(1), 200);
}

TEST(CPlaneFrame, LampsLieAlongU) {
    const auto lamps = lamps_of(ceiling);
    ASSERT_EQ(lamps.size(), 12u);
    EXPECT_NEAR((lamps[0].a - Vec3(-500, -550, 2000)).length(), 0, 1e-12);
    EXPECT_NEAR((lamps[11].b - Vec3(500, 550, 2000)).length(), 0, 1e-12);
    EXPECT_EQ(lamps[3].luminance, ceiling.luminance);
    EXPECT_TRUE(lamps_of({.lamps = 0}).empty());
}

TEST(CPlaneLookup, MeetsThePlaneFromBothSidesButNotBehind) {
    const auto hit = c_plane_coordinates(ceiling, Vec3(0, 0, 0), Vec3(0.5, 0, 2));
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 1000);
    EXPECT_DOUBLE_EQ(hit->u, 1000);
    EXPECT_DOUBLE_EQ(hit->v, 600);
    EXPECT_TRUE(c_plane_coordinates(ceiling, Vec3(0, 0, 3000), Vec3(0, 0, -1)));
    EXPECT_FALSE(c_plane_coordinates(ceiling, Vec3(0, 0, 3000), Vec3(0, 0, 1)));
    EXPECT_FALSE(c_plane_coordinates(ceiling, Vec3(0, 0, 0), Vec3(1, 0, 1e-13)));
    EXPECT_FALSE(c_plane_coordinates(CPlane{.u = Vec3(0)}, Vec3(0, 0, -1), Vec3(0, 0, 1)));
    EXPECT_FALSE(c_plane_coordinates(CPlane{.v = {3, 0, 0}}, Vec3(0, 0, -1), Vec3(0, 0, 1)));
}

TEST(CPlaneLookup, SeesTheLampsInTheirColour) {
    EXPECT_EQ(mirrored_luminance(ceiling, Vec3(0, 50, 0), Vec3(0, 0, 1)), ceiling.luminance);
    EXPECT_EQ(mirrored_luminance(ceiling, Vec3(0, 75, 0), Vec3(0, 0, 1)), Rgb());
    EXPECT_EQ(mirrored_luminance(ceiling, Vec3(501, 50, 0), Vec3(0, 0, 1)), Rgb());
    EXPECT_EQ(mirrored_luminance(ceiling, Vec3(0, 50, 0), Vec3(0, 0, 1), Footprint::box(100, 80)),
              ceiling.luminance * 0.5);
    EXPECT_EQ(mirrored_luminance(ceiling, Vec3(500, 50, 0), Vec3(0, 0, 1), Footprint::box(10, 10)),
              ceiling.luminance * 0.5);
}

TEST(CPlaneLookup, FootprintIsTheDerivativeOfTheHit) {
    const Vec3 origin(30, -40, 100), direction(0.3, -0.5, 1.7);
    const RayDifferentials spread{
        {1, 0.2, -0.3}, {0.1, -0.7, 0.4}, {0.01, 0.02, -0.03}, {-0.02, 0, 0.01}};
    const auto hit = c_plane_coordinates(frame, origin, direction);
    const Footprint footprint = footprint_on(frame, *hit, spread);
    const double h = 1e-5;
    const auto slope = [&](const Vec3& o, const Vec3& d) {
        const auto ahead = c_plane_coordinates(frame, origin + o * h, direction + d * h);
        const auto behind = c_plane_coordinates(frame, origin - o * h, direction - d * h);
        return Vec2(ahead->u - behind->u, ahead->v - behind->v) / (2 * h);
    };
    EXPECT_NEAR((footprint.dx - slope(spread.origin_dx, spread.direction_dx)).length(), 0, 1e-6);
    EXPECT_NEAR((footprint.dy - slope(spread.origin_dy, spread.direction_dy)).length(), 0, 1e-6);
    EXPECT_GT(footprint.dx.length(), 10);
}

TEST(CPlaneLookup, FilteredStripesAreTheMeanOfManyRays) {
    for (const auto look : {MirrorModel::flat, MirrorModel::tube}) {
        for (const Vec3& direction : {Vec3(0.05, 0.1, 1), Vec3(-0.2, 0.7, 1)}) {
            const RayDifferentials spread = pixel_of(90, 0.6);
            const Vec3 origin = Vec3(20, 63, 2000) - direction * 2000;
            const auto hit = c_plane_coordinates(frame, origin, direction);
            const Footprint footprint = footprint_on(frame, *hit, spread);
            const double coverage = look_up(frame, origin, direction, footprint, look).coverage;
            EXPECT_NEAR(coverage, mean_of_points(origin, direction, spread, look), 2e-3);
        }
    }
}

TEST(CPlaneLookup, EndsOfTubesAreSeenWhereTheirRimsAre) {
    // Obliquely along the lamp, over its end; the error of the flat strip is the height of the rim.
    const Vec3 direction(1, 0.1, 1);
    const RayDifferentials spread = pixel_of(60, 0);
    const Vec3 origin = Vec3(505, 50, 2000) - direction * 2000;
    const auto hit = c_plane_coordinates(frame, origin, direction);
    const Footprint footprint = footprint_on(frame, *hit, spread);
    const auto error = [&](MirrorModel look) {
        return std::abs(look_up(frame, origin, direction, footprint, look).coverage -
                        mean_of_points(origin, direction, spread, MirrorModel::tube));
    };
    EXPECT_LT(error(MirrorModel::tube), 0.01);
    EXPECT_GT(error(MirrorModel::flat), 0.1);
}

TEST(CPlaneLookup, ExactIsTheMeanOfManyRaysOverEveryEnd) {
    for (const bool caps : {false, true}) {
        CPlane plane = ceiling;
        plane.luminous_caps = caps;
        const CPlaneFrame row(plane);
        for (const double u : {-5.0, 1003.0}) {
            const Vec3 direction(0.8, 0.3, 1), from = row.at(u, row.axis(6)) - direction * 2000;
            const RayDifferentials spread = pixel_of(70, 0.3);
            const auto hit = c_plane_coordinates(row, from, direction);
            const Footprint footprint = footprint_on(row, *hit, spread);
            int lit = 0;
            constexpr int side = 300;
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) {
                    const double x = (i + 0.5) / side - 0.5, y = (j + 0.5) / side - 0.5;
                    const Vec3 d = direction + spread.direction_dx * x + spread.direction_dy * y;
                    const auto tube = nearest_tube(row, from, d);
                    lit += tube && (caps || !tube->cap);
                }
            const double mean = lit / static_cast<double>(side * side);
            EXPECT_GT(mean, 0.05);
            const auto coverage = [&](MirrorModel look) {
                return look_up(row, from, direction, footprint, look).coverage;
            };
            EXPECT_NEAR(coverage(MirrorModel::exact), mean, 0.01) << caps << " " << u;
            EXPECT_NEAR(coverage(MirrorModel::tube), mean, 0.03) << caps << " " << u;
        }
    }
}

TEST(CPlaneLookup, RowLooksClosedAtGrazingAngles) {
    const Vec3 direction(0, 1, 0.05), origin = Vec3(0, 0, 2000) - direction * 1000;
    EXPECT_EQ(look_up(frame, origin, direction).coverage, 1);
    EXPECT_EQ(look_up(frame, origin, direction, Footprint::box(5, 5)).coverage, 1);
    EXPECT_GT(apparent_diameter(frame, frame.vector(direction)), frame.pitch);
}

// A body that crosses the plane of the lamps: rays from there may leave the tubes behind, though
// their lines run through the strips.
TEST(CPlaneLookup, TubesBehindARayFromAmongThemAreNotSeen) {
    test::Random random(11);
    int ahead = 0, behind = 0;
    for (int lamps : {1, 12}) {
        CPlane plane = ceiling;
        plane.lamps = lamps;
        const CPlaneFrame row(plane);
        for (int trial = 0; trial < 4000; ++trial) {
            const double sense = trial % 2 ? 1 : -1, beyond = test::uniform(random, 30, 3000);
            const double aside = sense > 0 ? row.first - beyond : row.last() + beyond;
            const Vec3 origin = row.at(test::uniform(random, 300, 700), aside) +
                                row.normal * test::uniform(random, -19, 19);
            const Vec3 direction(0, test::uniform(random, 0, 1) < 0.5 ? sense : -sense,
                                 test::uniform(random, -0.02, 0.02));
            const auto hit = c_plane_coordinates(row, origin, direction);
            if (!hit) continue;
            ASSERT_TRUE(starts_among_tubes(row, *hit));
            const double seen =
                look_up(row, *hit, origin, direction, Footprint::box(1e-6, 1e-6), MirrorModel::tube)
                    .coverage;
            const bool away = direction.y * sense < 0;
            EXPECT_TRUE(!away || seen == 0);
            EXPECT_TRUE(away || lamps > 1 ||
                        (seen > 0.5) == nearest_tube(row, origin, direction).has_value());
            behind += away, ahead += !away && seen > 0;
        }
    }
    EXPECT_GT(behind, 1000);
    EXPECT_GT(ahead, 500);
}

TEST(CPlaneLookup, TooFineStripesGiveTheirMeanAndSaySo) {
    const auto fine = look_up(frame, Vec3(0, 0, 0), Vec3(0, 0, 1), Footprint::box(10, 401));
    EXPECT_FALSE(fine.resolved);
    EXPECT_DOUBLE_EQ(fine.coverage, 0.4);
    EXPECT_TRUE(look_up(frame, Vec3(0), Vec3(0, 0, 1), Footprint::box(10, 399)).resolved);
}
