// Gaps and kinks between panels that bend into flanges.
#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace keiko {
namespace {

constexpr Vec3 along{0, 200, 0}; // mm: the course of every groove here

/// A flange from (x, y, z) downwards, off the vertical by `splay` mm on 50.
void add_flange(test::ModelBuilder& builder, const Vec3& from, double splay,
                const Vec3& course = along) {
    builder.plane(from, {splay, 0, -50}, course);
}

/// Two panels, `gap` mm apart and a step of `step` mm, the second turned by an angle. Flanges lead
/// down from both, splayed apart by `splay` mm over 50 mm each.
SurfaceModel flanged(double gap, double step, double degrees, double splay) {
    test::ModelBuilder builder;
    const double angle = degrees_to_radians(degrees);
    builder.plane({-100, 0, 0}, {100, 0, 0}, along);
    builder.plane({gap, 0, step}, {100 * std::cos(angle), 0, 100 * std::sin(angle)}, along);
    add_flange(builder, {0, 0, 0}, -splay);
    add_flange(builder, {gap, 0, step}, splay);
    return builder.build();
}

/// Number of findings worth a look of a code, at these faces and with this value.
std::ptrdiff_t looks_of(const SurfaceModel& model, const std::string& code,
                        const std::string& faces, double value) {
    const Inspection inspection = inspect(model);
    EXPECT_EQ(inspection.verdict, Verdict::pass);
    return std::count_if(inspection.looks.begin(), inspection.looks.end(), [&](const Check& look) {
        return look.code == code && look.faces == faces &&
               std::abs(look.worst.value - value) < 1e-9;
    });
}

std::ptrdiff_t openings_of(const SurfaceModel& model, double width,
                           const std::string& faces = "face 1 | face 2") {
    return looks_of(model, "KEIKO-OPENING", faces, width);
}

TEST(Grooves, BetweenFlangedPanelsAreWorthALookAtAnyTurn) {
    for (const double gap : {0.012, 0.02, 0.1, 0.4})
        for (const double step : {0.0, -0.3})
            for (const double degrees : {-30.0, -5.1, 0.0, 3.0, 4.9, 5.1, 30.0})
                EXPECT_EQ(openings_of(flanged(gap, step, degrees, 20), std::hypot(gap, step)), 1)
                    << gap << ' ' << step << ' ' << degrees;
    EXPECT_EQ(openings_of(flanged(0.009, 0, 0, 20), 0.009), 0); // no wider than a gap may be
    EXPECT_EQ(openings_of(flanged(0.6, 0, 0, 20), 0.6), 0);     // beyond the join distance
}

TEST(Grooves, AreListedOnceForTheFacesThatTurnLeast) {
    // At 60 and 80 degrees the second panel goes on from the first one's flange.
    for (const double degrees : {10.0, 60.0, 80.0}) {
        const SurfaceModel model = flanged(0.2, 0, degrees, 20);
        const std::vector<Check> looks = inspect(model).looks;
        const std::string faces = degrees > 30 ? "face 2 | face 3" : "face 1 | face 2";
        ASSERT_EQ(looks.size(), 1u) << degrees;
        EXPECT_EQ(looks[0].faces, faces);
        EXPECT_NEAR(looks[0].worst.value, 0.2, 1e-9);
    }
}

TEST(Grooves, OfNoGapAreWorthALookWhereTheyBend) {
    for (const double gap : {0.004, 0.009}) {
        EXPECT_EQ(looks_of(flanged(gap, 0, 0.3, 20), "G-SU-NT", "face 1 | face 2", 0.3), 1) << gap;
        EXPECT_EQ(looks_of(flanged(gap, 0, 0.09, 20), "G-SU-NT", "face 1 | face 2", 0.09), 0)
            << gap;
    }
}

/// Two flat panels with a seam along the first half of their border. Along the second half they
/// stand apart, with a flange each.
SurfaceModel seam_and_groove(double gap) {
    test::ModelBuilder builder;
    const double u = gap / 100;
    builder.plane({-100, 0, 0}, {100, 0, 0}, along);
    builder.plane({0, 0, 0}, {100, 0, 0}, along);
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {u, 1}, {u, 0.5}, {0, 0.5}});
    add_flange(builder, {0, 100, 0}, -20, along / 2);
    add_flange(builder, {gap, 100, 0}, 20, along / 2);
    return builder.build();
}

TEST(Grooves, AreFoundBesideASeamOfTheSamePanels) {
    for (const double gap : {0.02, 0.1, 0.3, 0.45})
        EXPECT_EQ(openings_of(seam_and_groove(gap), gap), 1) << gap;
}

/// A flat panel with a slit of `gap` by 100 mm, and a wall along either of its long sides.
SurfaceModel slit(double gap) {
    test::ModelBuilder builder;
    const double low = 0.5 - gap / 400, high = 0.5 + gap / 400;
    builder.plane({-100, 0, 0}, {200, 0, 0}, along);
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.polygon({{low, 0.25}, {low, 0.75}, {high, 0.75}, {high, 0.25}});
    add_flange(builder, {-gap / 2, 50, 0}, -20, along / 2);
    add_flange(builder, {gap / 2, 50, 0}, 20, along / 2);
    return builder.build();
}

TEST(Grooves, AreFoundInOneFace) {
    EXPECT_EQ(openings_of(slit(0.3), 0.3, "face 1"), 1);
}

/// Two panels, and one face that leads from one down and up to the other, over a cubic's course.
SurfaceModel gutter(double gap, double depth) {
    test::ModelBuilder builder;
    builder.plane({-100, 0, 0}, {100, 0, 0}, along);
    builder.plane({gap, 0, 0}, {100, 0, 0}, along);
    builder.patch(3, 1,
                  {{0, 0, 0},
                   along,
                   {0, 0, -depth},
                   along + Vec3(0, 0, -depth),
                   {gap, 0, -depth},
                   along + Vec3(gap, 0, -depth),
                   {gap, 0, 0},
                   along + Vec3(gap, 0, 0)});
    return builder.build();
}

TEST(Grooves, MayHaveOneFaceAsBothWalls) {
    EXPECT_EQ(openings_of(gutter(0.3, 10), 0.3), 1);
    EXPECT_EQ(openings_of(gutter(0.3, 0.1), 0.3), 0); // a bead: the strip closes the gap
}

TEST(Grooves, AreNoneWhereStripsCloseTheGap) {
    test::ModelBuilder builder;
    builder.plane({-100, 0, 0}, {100, 0, 0}, along);
    builder.plane({0, 0, 0}, {0.1, 0, -0.3}, along);
    builder.plane({0.1, 0, -0.3}, {100, 0, 0}, along);
    EXPECT_EQ(openings_of(builder.build(), std::hypot(0.1, 0.3)), 0);
    test::ModelBuilder bead; // of two faces
    bead.plane({-100, 0, 0}, {100, 0, 0}, along);
    bead.plane({0, 0, 0}, {0.15, 0, 0.2}, along);
    bead.plane({0.15, 0, 0.2}, {0.15, 0, -0.2}, along);
    bead.plane({0.3, 0, 0}, {100, 0, 0}, along);
    EXPECT_EQ(openings_of(bead.build(), 0.3), 0);
}

/// Two flat sheets of 0.4 mm with their edges side by side: fronts, edges and backs.
SurfaceModel sheets(double gap) {
    constexpr double thickness = 0.4; // mm
    test::ModelBuilder builder;
    builder.plane({-100, 0, 0}, {100, 0, 0}, along);
    builder.plane({gap, 0, 0}, {100, 0, 0}, along);
    for (const double x : {0.0, gap}) builder.plane({x, 0, 0}, {0, 0, -thickness}, along);
    builder.plane({-100, 0, -thickness}, {100, 0, 0}, along);
    builder.plane({gap, 0, -thickness}, {100, 0, 0}, along);
    return builder.build();
}

TEST(Grooves, BetweenThinSheetsAreFoundThoughTheirEdgesAreStrips) {
    for (const double gap : {0.05, 0.15}) {
        const Inspection inspection = inspect(sheets(gap));
        const auto is_groove = [&](const Check& look) {
            return look.code == "KEIKO-OPENING" && look.faces == "face 1 | face 2";
        };
        EXPECT_EQ(std::count_if(inspection.looks.begin(), inspection.looks.end(), is_groove), 1)
            << gap;
    }
}

} // namespace
} // namespace keiko
