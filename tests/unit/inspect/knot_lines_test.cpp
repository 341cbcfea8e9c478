#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

using test::ModelBuilder;
using test::sheet_length;

/// A B-spline sheet of 100 x 40 mm with a knot line at y = 0, where it turns by `degrees`; the knot
/// is as often there as the degree.
NurbsSurface bent_sheet(double degrees) {
    NurbsSurface sheet{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, {}};
    const double slope = std::tan(degrees_to_radians(degrees));
    for (const double x : {0.0, sheet_length})
        for (const double y : {-20.0, -10.0, 0.0, 10.0, 20.0})
            sheet.points.emplace_back(x, y, std::max(0.0, y) * slope, 1);
    return sheet;
}

TEST(MeasureKnotLines, CountAKnotAtWhichTheFaceTurnsAsASeam) {
    ModelBuilder builder;
    builder.nurbs(bent_sheet(0.3));
    const auto lines = measure_knot_lines(builder.build(), {});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(lines[0].internal);
    EXPECT_NEAR(lines[0].angle->value, 0.3, 1e-9);
    EXPECT_NEAR(lines[0].length, sheet_length, 1e-9);
    EXPECT_EQ(lines[0].verdict, Verdict::fail);
    EXPECT_EQ(lines[0].faces, "face 1, inside at v = 1");
}

TEST(MeasureKnotLines, LeaveOutSmoothKnots) {
    ModelBuilder builder;
    builder.nurbs(bent_sheet(0));
    EXPECT_TRUE(measure_knot_lines(builder.build(), {}).empty());
}

/// The only line in a sheet that stands for one of the file within `off` mm.
std::vector<MeasuredSeam> approximated(double degrees, double off) {
    ModelBuilder builder;
    builder.nurbs(bent_sheet(degrees));
    SurfaceModel model = builder.build();
    model.faces[0].approximated = off;
    return measure_knot_lines(model, {});
}

TEST(MeasureKnotLines, AreJudgedWhereTheFaceApproximatesOneOfTheFile) {
    const auto lines = approximated(0.3, 1e-6);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(lines[0].angle->value, 0.3, 1e-9);
    EXPECT_GT(lines[0].angle->bound, 1e-4);
    EXPECT_EQ(lines[0].verdict, Verdict::fail);
    EXPECT_TRUE(approximated(0, 1e-10).empty());
}

TEST(MeasureKnotLines, AreUndecidedWhereAnApproximationMayHideAKink) {
    for (const double degrees : {0.0, 0.3}) {
        const auto lines = approximated(degrees, 0.001);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_EQ(lines[0].verdict, Verdict::undecided);
    }
}

TEST(MeasureKnotLines, EndWhereTrimsDo) {
    ModelBuilder builder;
    builder.nurbs(bent_sheet(0.3));
    builder.polygon({{0.2, 0.5}, {0.6, 0.5}, {0.6, 1.5}, {0.2, 1.5}});
    const auto lines = measure_knot_lines(builder.build(), {});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NEAR(lines[0].length, 0.4 * sheet_length, 1e-8);
}

TEST(MeasureKnotLines, AreKeptInTheNarrowestMaterial) {
    for (const double width : {0.05, 0.005, 1e-5}) {
        ModelBuilder builder;
        builder.nurbs(bent_sheet(0.3));
        builder.polygon({{0.47, 0.5}, {0.47 + width, 0.5}, {0.47 + width, 1.5}, {0.47, 1.5}});
        const auto lines = measure_knot_lines(builder.build(), {});
        ASSERT_EQ(lines.size(), 1u) << width;
        EXPECT_NEAR(lines[0].length, width * sheet_length, 1e-8);
        EXPECT_EQ(lines[0].verdict, Verdict::fail);
    }
}

TEST(MeasureKnotLines, FindAKinkThatIsZeroAtSomePlaces) {
    // Along the knot at x = 0 the slope changes by (t - 0.11)(t - 0.5)(t - 0.87), in Bernstein
    // form.
    const std::array<double, 4> kink{-0.04785, 0.14738333333333334, -0.15071666666666667, 0.05785};
    NurbsSurface sheet{2, 3, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 0, 0, 0, 1, 1, 1, 1}, {}};
    for (const double x : {-20.0, -10.0, 0.0, 10.0, 20.0})
        for (std::size_t i = 0; i < 4; ++i)
            sheet.points.emplace_back(x, 30.0 * double(i), std::max(0.0, x) * kink[i], 1);
    ModelBuilder builder;
    builder.nurbs(sheet);
    const auto lines = measure_knot_lines(builder.build(), {});
    ASSERT_FALSE(lines.empty());
    double largest = 0;
    for (const MeasuredSeam& line : lines) largest = std::max(largest, line.angle->value);
    EXPECT_GT(largest, 2);
}

/// A sheet of 100 x 40 mm that is torn at y = 0, where it is `open` mm apart and turns by 30
/// degrees. Its control points beside the tear coincide, so that it bends sharply there too.
NurbsSurface torn_sheet(double open) {
    NurbsSurface sheet{1, 2, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1, 2, 2, 2}, {}};
    const double slope = std::tan(degrees_to_radians(30));
    for (const double x : {0.0, sheet_length}) {
        for (const double y : {-20.0, 0.0, 0.0}) sheet.points.emplace_back(x, y, 0, 1);
        for (const double y : {0.0, 0.0, 20.0})
            sheet.points.emplace_back(x, y, open + y * slope, 1);
    }
    return sheet;
}

TEST(MeasureKnotLines, StateATearAsOneGap) {
    for (const double open : {0.0002, 0.02, 0.3}) {
        ModelBuilder builder;
        builder.nurbs(torn_sheet(open));
        const auto lines = measure_knot_lines(builder.build(), {});
        ASSERT_EQ(lines.size(), 1U) << open;
        EXPECT_NEAR(lines[0].gap.value, open, 1e-9);
        EXPECT_EQ(lines[0].gap.verdict, open > 0.01 ? Verdict::fail : Verdict::pass);
        EXPECT_NEAR(lines[0].length, sheet_length, 1e-9);
    }
}

TEST(MeasureKnotLines, StateABendWhereTheFaceIsNotTorn) {
    for (const double open : {0.0, 0.00005}) {
        ModelBuilder builder;
        builder.nurbs(torn_sheet(open));
        const auto lines = measure_knot_lines(builder.build(), {});
        ASSERT_EQ(lines.size(), 1U) << open;
        ASSERT_TRUE(lines[0].angle) << open;
        EXPECT_NEAR(lines[0].angle->value, 30, 0.01) << open;
    }
}

TEST(MeasureKnotLines, CountWithSeamsInTheScrapsOfAFace) {
    // Two faces turn by 3 degrees along 0.06 mm, and one of them inside along 0.06 mm besides.
    constexpr double short_side = 0.06;
    const auto place = [](double x, double y) {
        const double slope = std::tan(degrees_to_radians(3));
        return Vec3(x, y, slope * (std::max(0.0, x) + std::max(0.0, x - 20)));
    };
    ModelBuilder builder;
    builder.plane(Vec3(-20, 0, 0), Vec3(20, 0, 0), Vec3(0, short_side, 0));
    NurbsSurface sheet{2, 1, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 0, 1, 1}, {}};
    for (const double x : {0.0, 10.0, 20.0, 30.0, 40.0})
        for (const double y : {0.0, short_side}) {
            const Vec3 p = place(x, y);
            sheet.points.emplace_back(p.x, p.y, p.z, 1);
        }
    builder.nurbs(sheet);
    const SurfaceModel model = builder.build();
    constexpr double near = 0.01;
    CriteriaPreset preset;
    preset.negligible = 0.1;
    const auto seams = measure_all_seams(model, pair_seams(model, near), preset, near).seams;
    int failing = 0;
    for (const MeasuredSeam& seam : seams)
        if (seam.angle && seam.angle->value > 2) failing += seam.verdict == Verdict::fail;
    EXPECT_EQ(failing, 2);
}

} // namespace
} // namespace keiko
