
#include "keiko/light/tubes/tube_hit.h"
#include "keiko/light/tubes/tube_irradiance.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace keiko;

namespace {

/// The oracle's row of lamps along x at height h over the point (0, 0, 0).
CPlane row_in(const test::OracleRow& row) {
    const int lamps = row.integer("in.n");
    const double pitch = row.number("in.pitch");
    return {.origin = {row.number("in.x0"), row.number("in.y0") - pitch / 2, row.number("in.h")},
            .u = {row.number("in.len"), 0, 0},
            .v = {0, lamps * pitch, 0},
            .lamps = lamps,
            .pitch = pitch,
            .diameter = row.number("in.d"),
            .luminance = Rgb(row.number("in.L")),
            .luminous_caps = true};
}

double sum_of_row(const CPlaneFrame& frame, const Vec3& point, const Vec3& normal,
                  TubeModel model) {
    const TubeRowIrradiance comb(frame, point, normal, model);
    double sum = 0;
    for (int i = 0; i < frame.lamps; ++i) sum += comb.solid_angle(i, IntervalSet::whole());
    return sum;
}

/// Brute force: pi times the share of rays, spread by their cosine over the directions above the
/// horizon, that meet a shining part of a lamp first.
double solid_angle_by_rays(const CPlaneFrame& frame, const Vec3& point, const Vec3& normal) {
    constexpr int side = 1200;
    const Vec3 x = normal.cross(std::abs(normal.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
    const Vec3 across = x.normalized(), up = normal.cross(across);
    int lit = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double r2 = (i + 0.5) / side, phi = 2 * std::numbers::pi * (j + 0.5) / side;
            const double r = std::sqrt(r2);
            const Vec3 ray = across * (r * std::cos(phi)) + up * (r * std::sin(phi)) +
                             normal * std::sqrt(1 - r2);
            const auto tube = nearest_tube(frame, point, ray);
            lit += tube && (!tube->cap || frame.luminous_caps) ? 1 : 0;
        }
    return std::numbers::pi * lit / (static_cast<double>(side) * side);
}

/// Six thick tubes, 300 mm over the floor.
const CPlane close_row{
    .origin = {-400, -450, 300}, .u = {800, 0, 0}, .v = {0, 900, 0}, .lamps = 6, .diameter = 100};

} // namespace

TEST(TubeRowIrradiance, AgreesWithOracle) {
    const test::OracleTable table("lamp_array");
    test::WorstError truth("E_true"), rectangles("E_sum_rect"), alone("E_sum_cyl");
    for (const auto& row : table) {
        const CPlane plane = row_in(row);
        const CPlaneFrame frame(plane);
        const Vec3 normal = row.unit("in.N");
        const double lit = plane.luminance.g;
        truth.compare(row, lit * sum_of_row(frame, Vec3(0), normal, TubeModel::cylinder),
                      row.number("out.E_true"), 1e-9);
        rectangles.compare(row, lit * sum_of_row(frame, Vec3(0), normal, TubeModel::rectangle),
                           row.number("out.E_sum_rect"), 1e-11);
        double sum = 0;
        for (const TubeLamp& lamp : lamps_of(plane))
            sum += irradiance(lamp, Vec3(0), normal, IntervalSet::whole(), TubeModel::cylinder).g;
        alone.compare(row, sum, row.number("out.E_sum_cyl"), 1e-9);
    }
}

TEST(TubeRowIrradiance, IsWhatRaysMeetFromEitherSideAndBeyondTheEnds) {
    const Vec3 beside(50, -900, 120), above(-100, 1000, 420), beyond(-900, -700, 200);
    for (const bool caps : {false, true}) {
        CPlane plane = close_row;
        plane.luminous_caps = caps;
        const CPlaneFrame frame(plane);
        for (const Vec3& point : {beside, above, beyond}) {
            const Vec3 normal = (Vec3(0, 0, 300) - point + Vec3(20, 30, 100)).normalized();
            ASSERT_TRUE(TubeRowIrradiance(frame, point, normal, TubeModel::cylinder).overlapping());
            const double by_rays = solid_angle_by_rays(frame, point, normal);
            EXPECT_NEAR(sum_of_row(frame, point, normal, TubeModel::cylinder), by_rays,
                        2e-3 * by_rays);
        }
    }
}

TEST(TubeRowIrradiance, ALampHidesItsRowFromPointsBeforeItsEnd) {
    const CPlaneFrame frame(close_row);
    // The third lamp's axis ends 400 mm off the middle of the plane, at y = -75.
    for (const Vec3& point : {Vec3(-405, -75, 300), Vec3(-420, -90, 320), Vec3(460, -60, 270)}) {
        const Vec3 normal = Vec3(-point.x, 350, -40).normalized();
        double alone = 0;
        for (const TubeLamp& lamp : lamps_of(close_row))
            alone += projected_solid_angle(lamp, point, normal);
        const double by_rays = solid_angle_by_rays(frame, point, normal);
        const double found = sum_of_row(frame, point, normal, TubeModel::cylinder);
        EXPECT_NEAR(found, by_rays, 2e-3 * by_rays + 1e-5);
        EXPECT_LT(found, 0.8 * alone);
    }
}

// From there on what the lamp hides bends as sharply as the point is close to its surface's
// extension, on either side.
TEST(TubeRowIrradiance, ALampHidesItsRowFromPointsOnItsSurfacesExtension) {
    CPlane plane = close_row;
    plane.pitch = 105;
    const CPlaneFrame frame(plane);
    const Vec3 normal(0.2, 0.6, -0.77);
    const auto from = [&](double distance) {
        const Vec3 point(-410, frame.axis(2), plane.origin.z + distance);
        return sum_of_row(frame, point, normal.normalized(), TubeModel::cylinder);
    };
    const Vec3 at(-410, frame.axis(2), plane.origin.z + 49.99);
    const double by_rays = solid_angle_by_rays(frame, at, normal.normalized());
    EXPECT_NEAR(from(49.99), by_rays, 2e-3 * by_rays);
    for (const double off : {1e-1, 1e-2, 1e-3, 1e-5})
        EXPECT_NEAR(from(50 - off), from(50 + off), 0.03 * std::sqrt(off) * from(50 + off)) << off;
}

TEST(TubeRowIrradiance, LampsThatStandClearAddUp) {
    const CPlaneFrame frame(close_row);
    const Vec3 point(30, 100, -600), normal(0, 0, 1);
    EXPECT_FALSE(TubeRowIrradiance(frame, point, normal, TubeModel::automatic).overlapping());
    double sum = 0;
    for (const TubeLamp& lamp : lamps_of(close_row))
        sum += projected_solid_angle(lamp, point, normal);
    EXPECT_EQ(sum_of_row(frame, point, normal, TubeModel::automatic), sum);
}

TEST(TubeRowIrradiance, ThePaperCountsHiddenLampsInFull) {
    const CPlaneFrame frame(close_row);
    const Vec3 point(50, -900, 200), normal = Vec3(0, 1, 0.3).normalized();
    const double hidden = sum_of_row(frame, point, normal, TubeModel::automatic);
    EXPECT_GT(sum_of_row(frame, point, normal, TubeModel::nishita), 1.5 * hidden);
    EXPECT_FALSE(TubeRowIrradiance(frame, point, normal, TubeModel::nishita).overlapping());
}
