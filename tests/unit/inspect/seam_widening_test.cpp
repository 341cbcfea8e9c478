#include "keiko/inspect/seams/seam_chain.h"

#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

constexpr double length = 100, join = 0.5; ///< mm

/// Two flat sheets whose borders part from x = 0 on, by `slope` mm a mm.
SurfaceModel wedge(double slope) {
    test::ModelBuilder builder;
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 50, 0});
    builder.patch(1, 1, {{0, 0, 0}, {0, -50, 0}, {length, -slope * length, 0}, {length, -60, 0}});
    return builder.build();
}

/// Their seam as it is paired, up to `gap` mm: from x to the foot on the line y = -slope x.
Seam paired(double slope, double gap) {
    Seam seam = test::first_sides();
    const double x = gap * std::hypot(1, slope) / slope;
    seam.a.end = x / length;
    seam.b.end = seam.a.end / (1 + slope * slope);
    return seam;
}

std::vector<Seam> widened(double slope, std::vector<Seam> seams) {
    const SurfaceModel model = wedge(slope);
    const BoundaryCurves curves(model);
    return widened_seams(curves, seams, join);
}

TEST(WidenedSeams, GoOnToTheEndOfTheBorders) {
    const Seam seam = widened(0.04, {paired(0.04, join)}).at(0);
    EXPECT_EQ(seam.a.begin, 0);
    EXPECT_NEAR(seam.a.end, 1, 1e-9);
    EXPECT_NEAR(seam.b.end, 1 / (1 + 0.04 * 0.04), 1e-6);
}

TEST(WidenedSeams, EndWhereTheGapIsTenTimesTheJoinDistance) {
    const Seam seam = widened(0.1, {paired(0.1, join)}).at(0);
    EXPECT_NEAR(seam.a.end * length, 10 * join * std::hypot(1, 0.1) / 0.1, 1e-6);
}

TEST(WidenedSeams, StayAsTheyAreWhereBordersDivergeByMoreThanTenDegrees) {
    for (const double degrees : {9.9, 10.1}) {
        const double slope = test::SeamSlope::tangent(degrees);
        const Seam before = paired(slope, join);
        const Seam after = widened(slope, {before}).at(0);
        EXPECT_EQ(after.a.end > before.a.end, degrees < 10) << degrees;
    }
}

TEST(WidenedSeams, StayAsTheyAreWhereNoGapEndedThem) {
    const Seam before = paired(0.04, 0.9 * join);
    EXPECT_EQ(widened(0.04, {before}).at(0), before);
}

TEST(WidenedSeams, EndWhereAnotherSeamBeginsOnEitherBorder) {
    for (const bool on_a : {true, false}) {
        Seam other = test::first_sides();
        BoundaryInterval& shared = on_a ? other.a : other.b;
        (on_a ? other.b : other.a) = {0, 0, natural_side + 2, 0, 0.1};
        shared.begin = 0.4, shared.end = 0.9;
        const Seam seam = widened(0.04, {paired(0.04, join), other}).at(0);
        EXPECT_NEAR((on_a ? seam.a : seam.b).end, 0.4, 1e-6);
    }
}

} // namespace
} // namespace keiko
