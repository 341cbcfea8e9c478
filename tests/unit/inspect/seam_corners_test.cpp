#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/seam_measure.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

/// Two seams of the same two faces that come as near each other as the join distance without being
/// one line.
namespace keiko {
namespace {

using test::ModelBuilder;

constexpr double length = 240, join = 0.5, feature_angle = 5; ///< mm, mm, degrees

double tangent(double degrees) {
    return std::tan(degrees_to_radians(degrees));
}

/// A flat face with a slot of `width` mm that is open at x = length, and a strip that fills it. The
/// slopes are tangents at x = 0, length / 3, 2 / 3 length and length, of a cubic's control values:
/// what the strip rises by along either side of the slot.
SurfaceModel slotted(double width, const std::array<double, 4>& lower,
                     const std::array<double, 4>& upper) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 100, 0});
    const double y = 0.5, top = y + width / 100;
    builder.polygon({{0, 0}, {1, 0}, {1, y}, {0.1, y}, {0.1, top}, {1, top}, {1, 1}, {0, 1}});
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = length * (0.1 + 0.3 * double(i));
        points.push_back({x, 50, 0});
        points.push_back({x, 50 + width / 3, lower[i] * width / 3});
        points.push_back({x, 50 + width * 2 / 3, upper[i] * width / 3});
        points.push_back({x, 50 + width, 0});
    }
    builder.patch(3, 3, points);
    return builder.build();
}

std::vector<MeasuredSeam> measured(const SurfaceModel& model) {
    CriteriaPreset preset;
    preset.curvature.reset();
    return measure_seams(model, pair_seams(model, join), preset, join).seams;
}

TEST(SeamCorners, ACreaseExcusesNothingAtTheOtherSideOfANarrowStrip) {
    // Towards the open end the crease falls evenly to the feature angle. From there back along
    // the other side the angle goes on falling at the same rate, and on to nothing without a step.
    const double edge = tangent(feature_angle);
    for (const double width : {0.45, 0.3, 0.05, 0.02}) {
        SCOPED_TRACE(width);
        const SurfaceModel model =
            slotted(width, {4 * edge, 3 * edge, 2 * edge, edge * (1 + 1e-12)}, {0, 0, 0, edge});
        double faulty = 0;
        for (const MeasuredSeam& seam : measured(model)) {
            if (seam.middle.y < 50 + width / 2 || seam.length < 1) continue;
            if (seam.verdict == Verdict::fail) faulty += seam.length;
            EXPECT_NE(seam.kind, SeamClass::run_out);
        }
        EXPECT_NEAR(faulty, 0.9 * length, 1e-6);
    }
}

TEST(SeamCorners, BothSidesOfANarrowStripAreLinesOfTheirOwn) {
    const SurfaceModel model = slotted(0.3, {0, 0, 0, 0}, {0, 0, 0, 0});
    const auto seams = measured(model);
    EXPECT_EQ(line_count(seams), 3u); // both sides and the end of the slot
    for (const MeasuredSeam& seam : seams) EXPECT_EQ(seam.verdict, Verdict::pass);
}

/// Two flat faces whose common border steps sideways by `step` mm at x = length / 2.
std::size_t lines_with_a_step(double step) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 100, 0});
    const double low = 0.5, high = low + step / 100;
    builder.polygon({{0, 0}, {1, 0}, {1, high}, {0.5, high}, {0.5, low}, {0, low}});
    builder.plane({0, 0, 0}, {length, 0, 0}, {0, 100, 0});
    builder.polygon({{0, low}, {0.5, low}, {0.5, high}, {1, high}, {1, 1}, {0, 1}});
    return line_count(measured(builder.build()));
}

TEST(SeamCorners, ALineThatStepsAsideIsNotOneLine) {
    EXPECT_EQ(lines_with_a_step(0.3), 3u);
    EXPECT_EQ(lines_with_a_step(0.05), 3u);
    EXPECT_EQ(lines_with_a_step(0.002), 1u); // a vertex of a file is no better
}

/// A sheet from y = 0 to 5 (`side` 1) or -5, bent with a radius of 100 mm, that rises by `slope`
/// from the border more than that. Its border has notches of that depth every 0.02 mm.
void bent_sheet(ModelBuilder& builder, double side, double slope, double high) {
    constexpr double wide = 4, deep = 5, radius = 100, period = 0.02;
    std::vector<Vec3> points; // of z = y^2 / 2 radius + slope y
    for (const double x : {0.0, wide}) {
        points.push_back({x, 0, 0});
        points.push_back({x, side * deep / 2, side * slope * deep / 2});
        points.push_back({x, side * deep, side * slope * deep + deep * deep / (2 * radius)});
    }
    builder.patch(1, 2, points);
    std::vector<Vec2> corners{{1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (double x = period; high > 0 && x < wide - period / 2; x += period) {
        corners.emplace_back((x - period / 2) / wide, high / deep);
        corners.emplace_back(x / wide, 0);
    }
    builder.polygon(corners);
}

TEST(SeamCorners, SmallTeethOfABorderAreNone) {
    for (const double high : {0.002, 0.004})
        for (const double degrees : {0.0, 1.0})
            for (const bool teeth_first : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << high << " mm, " << degrees << ", " << teeth_first);
                ModelBuilder builder;
                bent_sheet(builder, 1, 0, teeth_first ? high : 0);
                bent_sheet(builder, -1, tangent(degrees), teeth_first ? 0 : high);
                const Inspection found = inspect(builder.build());
                EXPECT_EQ(found.verdict, degrees > 0 ? Verdict::fail : Verdict::pass);
                EXPECT_TRUE(found.looks.empty());
                ASSERT_EQ(found.counts.scraps, 0u);
                ASSERT_EQ(found.seams.size(), 1u);
                EXPECT_NEAR(found.seams[0].length, teeth_first ? 4 * std::hypot(1, high / 0.01) : 4,
                            0.1);
                EXPECT_LE(found.seams[0].gap.value, high + 1e-6);
                EXPECT_GE(found.seams[0].gap.value, 0.7 * high); // to the nearest flank
                EXPECT_NEAR(found.seams[0].angle->value, degrees, 0.01);
            }
}

} // namespace
} // namespace keiko
