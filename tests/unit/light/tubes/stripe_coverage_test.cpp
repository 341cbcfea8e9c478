#include "keiko/light/tubes/stripe_coverage.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

using namespace keiko;

namespace {

CPlaneFrame comb(int lamps, double pitch, double diameter) {
    return CPlaneFrame({.origin = Vec3(0),
                        .u = {1000, 0, 0},
                        .v = {0, lamps * pitch, 0},
                        .lamps = lamps,
                        .pitch = pitch,
                        .diameter = diameter});
}

} // namespace

TEST(StripeCoverage, AgreesWithOracle) {
    const test::OracleTable table("stripe_coverage");
    test::WorstError box("coverage"), tent("tri");
    for (const auto& row : table) {
        const double pitch = row.number("in.pitch"), d = row.number("in.d");
        const CPlaneFrame frame = comb(row.integer("in.n"), pitch, d);
        const double center = row.number("in.vc") - row.number("in.v0") + frame.first;
        const double w = row.number("in.w");
        box.compare(row, comb_coverage<double>(frame, true, d, center, {w, 0}),
                    row.number("out.coverage"), 1e-11);
        tent.compare(row, comb_coverage<double>(frame, true, d, center, {w, -w}),
                     row.number("out.tri"), 1e-11);
    }
}

TEST(StripeCoverage, TrapezoidIsTheMeanOfBoxes) {
    const CPlaneFrame frame = comb(7, 40, 15);
    const double wide = 33, narrow = 12, center = 101;
    double mean = 0;
    const int boxes = 4000;
    for (int i = 0; i < boxes; ++i) {
        const double offset = ((i + 0.5) / boxes - 0.5) * narrow;
        mean += comb_coverage<double>(frame, true, 15, center + offset, {wide, 0}) / boxes;
    }
    EXPECT_NEAR(comb_coverage<double>(frame, true, 15, center, {narrow, wide}), mean, 1e-7);
}

TEST(StripeCoverage, APointIsInOrOut) {
    const CPlaneFrame frame = comb(3, 100, 20);
    const PixelFilter point(0, 0);
    EXPECT_EQ(comb_coverage<double>(frame, true, 20, frame.axis(1) + 9.99, point), 1);
    EXPECT_EQ(comb_coverage<double>(frame, true, 20, frame.axis(1) + 10.01, point), 0);
    EXPECT_EQ(comb_coverage<double>(frame, true, 20, frame.axis(0) - 10.01, point), 0);
    EXPECT_EQ(comb_coverage<double>(frame, true, 20, 1e300, point), 0);
}

TEST(StripeCoverage, OverlappingStripsCountOnce) {
    const CPlaneFrame frame = comb(5, 30, 20);
    EXPECT_DOUBLE_EQ(comb_coverage<double>(frame, true, 45, frame.axis(2) + 15, {50, 0}), 1);
    EXPECT_DOUBLE_EQ(comb_coverage<double>(frame, true, 45, frame.last() + 22.5, {10, 0}), 0.5);
    EXPECT_DOUBLE_EQ(mean_coverage<double>(frame, 45, frame.axis(2), {50, 0}), 1);
}

TEST(StripeCoverage, MeanIsDutyInsideTheComb) {
    const CPlaneFrame frame = comb(20, 50, 20);
    EXPECT_DOUBLE_EQ(mean_coverage<double>(frame, 20, 500, {300, 0}), 0.4);
    EXPECT_DOUBLE_EQ(mean_coverage<double>(frame, 20, 0, {300, 0}), 0.2);
    EXPECT_NEAR(comb_coverage<double>(frame, true, 20, 507, {307, 0}), 0.4, 0.05);
}

TEST(StripeCoverage, MeanOfAClosedRowEndsWhereItsStripsDo) {
    const CPlaneFrame frame = comb(3, 50, 20);
    for (const double width : {50.0, 80.0, 900.0})
        for (const double center : {-430.0, -40.0, 70.0, 300.0})
            EXPECT_DOUBLE_EQ(mean_coverage<double>(frame, width, center, {250, 40}),
                             comb_coverage<double>(frame, true, width, center, {250, 40}));
}

TEST(StripeCoverage, AnEmptyRowCoversNothing) {
    const CPlaneFrame frame({.lamps = 0});
    EXPECT_EQ(comb_coverage<double>(frame, true, 26, 0, {10, 10}), 0);
    EXPECT_EQ(mean_coverage<double>(frame, 26, 0, {10, 10}), 0);
}
