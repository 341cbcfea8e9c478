#include "keiko/light/tubes/tube_hit.h"

#include "keiko/light/tubes/c_plane_lookup.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <random>

using namespace keiko;

namespace {

/// The oracle's plane: its comb starts at v0 and its lamps at u0.
CPlane plane_in(const test::OracleRow& row) {
    const Vec3 u = row.unit("in.U"), v = row.vector("in.V");
    const Vec3 across = (v - u * u.dot(v)).normalized();
    const int lamps = row.integer("in.n");
    const double pitch = row.number("in.pitch"), u0 = row.number("in.u0");
    return {.origin = row.vector("in.Oc") + u * u0 + across * (row.number("in.v0") - pitch / 2),
            .u = u * (row.number("in.u1") - u0),
            .v = v * (lamps * pitch / v.dot(across)),
            .lamps = lamps,
            .pitch = pitch,
            .diameter = row.number("in.d")};
}

const CPlane ceiling{.origin = {-500, -600, 2000},
                     .u = {1000, 0, 0},
                     .v = {0, 1200, 0},
                     .lamps = 12,
                     .diameter = 40,
                     .luminance = Rgb(5000)};

} // namespace

TEST(CPlaneHit, AgreesWithOracle) {
    const test::OracleTable table("cplane_hit");
    test::WorstError t("t"), u("u"), v("v");
    for (const auto& row : table) {
        const CPlaneFrame frame(plane_in(row));
        const auto hit = c_plane_coordinates(frame, row.vector("in.Ro"), row.unit("in.dir"));
        ASSERT_EQ(hit.has_value(), row.number("out.t") > 0) << row.id();
        if (!hit) continue;
        const double offset = row.number("in.v0") - frame.first;
        t.compare(row, hit->t, row.number("out.t"), 1e-11);
        u.compare(row, hit->u + row.number("in.u0"), row.number("out.u"), 1e-11);
        v.compare(row, hit->v + offset, row.number("out.v"), 1e-11);
        EXPECT_EQ(strip_at(frame, hit->u, hit->v, frame.diameter).value_or(-1),
                  row.integer("out.lamp_flat"))
            << row.id();
    }
}

TEST(TubeHit, AgreesWithOracle) {
    const test::OracleTable table("cplane_hit");
    test::WorstError t("t_cyl");
    for (const auto& row : table) {
        const CPlaneFrame frame(plane_in(row));
        const auto hit = nearest_tube(frame, row.vector("in.Ro"), row.unit("in.dir"));
        ASSERT_EQ(hit ? hit->lamp : -1, row.integer("out.lamp_cyl")) << row.id();
        if (!hit) continue;
        t.compare(row, hit->t, row.number("out.t_cyl"), 1e-11);
        EXPECT_EQ(hit->cap, row.integer("out.cap") == 1) << row.id();
    }
}

TEST(TubeHit, ApparentDiameterTellsWhatRaysMeet) {
    const CPlaneFrame frame(ceiling);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    int met = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 direction(any(random), any(random), 0.4 + any(random) * 0.3);
        const Vec3 target(200 * any(random), 600 * any(random), 2000);
        const Vec3 origin = target - direction * 2000;
        const auto hit = c_plane_coordinates(frame, origin, direction);
        ASSERT_TRUE(hit);
        double nearest = 1e9;
        for (int lamp = 0; lamp < frame.lamps; ++lamp)
            nearest = std::min(nearest, std::abs(hit->v - frame.axis(lamp)));
        const bool expected = nearest < apparent_diameter(frame, frame.vector(direction)) / 2;
        EXPECT_EQ(nearest_tube(frame, origin, direction).has_value(), expected) << i;
        met += expected;
    }
    EXPECT_GT(met, 1000);
    EXPECT_LT(met, 4900);
}

TEST(TubeHit, MeetsTubesAlongTheirPlane) {
    const CPlaneFrame frame(ceiling);
    const auto first = nearest_tube(frame, Vec3(0, -2000, 2000), Vec3(0, 1, 0));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->lamp, 0);
    EXPECT_DOUBLE_EQ(first->t, 2000 - 550 - 20);
    EXPECT_EQ(nearest_tube(frame, Vec3(0, 2000, 2000), Vec3(0, -1, 0))->lamp, 11);
    EXPECT_FALSE(nearest_tube(frame, Vec3(0, -2000, 2021), Vec3(0, 1, 0)));
    const auto end_on = nearest_tube(frame, Vec3(-900, -550, 2010), Vec3(2, 0, 0));
    ASSERT_TRUE(end_on);
    EXPECT_TRUE(end_on->cap);
    EXPECT_DOUBLE_EQ(end_on->t, 200);
}

TEST(TubeHit, IgnoresWhatLiesBehindTheRay) {
    const CPlaneFrame frame(ceiling);
    EXPECT_TRUE(nearest_tube(frame, Vec3(0, -550, 0), Vec3(0, 0, 1)));
    EXPECT_TRUE(nearest_tube(frame, Vec3(0, -550, 4000), Vec3(0, 0, -1)));
    EXPECT_FALSE(nearest_tube(frame, Vec3(0, -550, 0), Vec3(0, 0, -1)));
    EXPECT_FALSE(nearest_tube(CPlaneFrame({.lamps = 0}), Vec3(0), Vec3(0, 0, 1)));
}
