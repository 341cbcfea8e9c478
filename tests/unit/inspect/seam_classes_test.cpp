// Seams cut where their class changes: creases that fade, spurs and folds.
#include "tests/unit/inspect/measured_seams.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using test::down;
using test::flat_sheet;
using test::hump;
using test::measured;
using test::ModelBuilder;
using test::peak;
using test::sheet_length;

/// A flat sheet beside one that leaves its plane by `height` times the hump.
SurfaceModel humped_crease(double height) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = sheet_length * double(i) / 3;
        points.push_back({x, 0, 0});
        points.push_back({x, -50, -height * hump[i]});
    }
    builder.patch(3, 1, points);
    return builder.build();
}

TEST(MeasureSeams, CutsAFadingCreaseWhereItsClassChanges) {
    const auto seams = measured(humped_crease(40));
    const auto at = [](double x) { return 0.8 * x * x * (1 - x) / 1; }; // tangent, x in shares
    const auto find = [&](SeamClass kind) {
        return std::find_if(seams.begin(), seams.end(),
                            [&](const MeasuredSeam& seam) { return seam.kind == kind; });
    };
    const auto crease = find(SeamClass::crease);
    ASSERT_NE(crease, seams.end());
    EXPECT_NEAR(crease->angle->value, radians_to_degrees(std::atan(40 * peak / 50)), 1e-9);
    EXPECT_NEAR(crease->angle->place.x, sheet_length * 2 / 3, 1e-3);
    for (const Vec3& end : {crease->course.front().front(), crease->course.front().back()})
        EXPECT_NEAR(radians_to_degrees(std::atan(at(end.x / sheet_length))), 5, 1e-6);
    double length = 0;
    for (const MeasuredSeam& seam : seams) length += seam.length;
    EXPECT_NEAR(length, sheet_length, 1e-5);
}

TEST(MeasureSeams, JudgesHowACreaseFades) {
    // The angle fades as the square of the way at one end, and by a straight line to nothing at the
    // other. Its slope there is that of 0.8 x^2 (1 - x) at x = 1.
    const auto seams = measured(humped_crease(40));
    const auto crease = std::find_if(seams.begin(), seams.end(),
                                     [](const MeasuredSeam& s) { return s.fading.has_value(); });
    ASSERT_NE(crease, seams.end());
    EXPECT_NEAR(crease->fading->value, radians_to_degrees(0.8) / sheet_length, 0.01);
    EXPECT_NEAR(crease->fading->place.x, sheet_length, 0.2);
    EXPECT_EQ(crease->verdict, Verdict::fail);
}

/// A sheet of 300 x 200 mm whose border overshoots by `spur` mm and folds back, beside one at 0.2
/// degrees.
SurfaceModel spurred(double spur) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 200, 0});
    builder.polygon({{0, 0}, {1, 0}, {1 - spur / 300, 0}, {1 - spur / 300, 1}, {0, 1}});
    builder.plane({0, 0, 0}, {300, 0, 0}, down(0.2, 200));
    return builder.build();
}

TEST(MeasureSeams, ASpurAtACornerExcusesNothing) {
    for (const double spur : {0.0002, 0.002, 0.012, 0.05, 0.09}) {
        SCOPED_TRACE(spur);
        const auto seams = measured(spurred(spur));
        double judged = 0, scraps = 0;
        for (const MeasuredSeam& seam : seams) {
            (seam.scrap ? scraps : judged) += seam.length;
            if (seam.scrap) continue;
            EXPECT_EQ(seam.kind, SeamClass::smooth);
            EXPECT_NEAR(seam.angle->value, 0.2, 1e-6);
            EXPECT_EQ(seam.verdict, Verdict::fail);
        }
        EXPECT_NEAR(judged, 300, spur + 1e-6);
        EXPECT_LE(scraps, spur + 1e-6);
    }
}

TEST(MeasureSeams, AFoldThatIsNotNegligibleFails) {
    Verdict verdict = Verdict::pass;
    for (const MeasuredSeam& seam : measured(spurred(0.4)))
        if (seam.kind == SeamClass::fold) verdict = std::max(verdict, seam.verdict);
    EXPECT_EQ(verdict, Verdict::fail);
}

} // namespace
} // namespace keiko
