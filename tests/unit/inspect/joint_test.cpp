// Joints between panels that stand apart: gap, flush and radii against closed forms.
#include "keiko/base/units.h"

#include "tests/support/shapes.h"
#include "tests/unit/inspect/joint_panels.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using namespace test::joints;

constexpr double exact = 1e-6; // mm

/// The only joint of panels, with sections all along.
Joint only_joint(const SurfaceModel& model, const JointLimits& limits = {}) {
    const std::vector<Joint> joints = joints_of(model, limits);
    EXPECT_EQ(joints.size(), 1u);
    const Joint joint = joints.at(0);
    EXPECT_TRUE(joint.extremes);
    EXPECT_EQ(joint.unmeasured, 0);
    return joint;
}

void expect_constant(const Joint& joint, double gap, double flush) {
    for (const JointStation& station : joint.stations) {
        ASSERT_TRUE(station.section);
        EXPECT_NEAR(station.section->gap, gap, exact);
        EXPECT_NEAR(station.section->flush, flush, exact);
        EXPECT_LT(station.section->bound, exact);
    }
    EXPECT_NEAR(joint.extremes->widest.gap, gap, exact);
    EXPECT_NEAR(joint.extremes->narrowest.gap, gap, exact);
    EXPECT_NEAR(joint.extremes->proudest.flush, flush, exact);
    EXPECT_NEAR(joint.extremes->deepest.flush, flush, exact);
    EXPECT_LT(joint.extremes->hidden_gap + joint.extremes->hidden_flush, exact);
}

TEST(Joints, OfFlatPanelsHaveGapFlushAndRadii) {
    for (const double gap : {0.6, 4.0, 14.9})
        for (const double flush : {-1.5, 0.0, 0.7}) {
            const Joint joint = only_joint(model_of(pair_of(gap, flush)));
            expect_constant(joint, gap, flush);
            EXPECT_NEAR(joint.length, 200, exact);
            const JointSection& section = *joint.stations.front().section;
            EXPECT_NEAR(section.sides[0].radius, 3, exact);
            EXPECT_NEAR(section.sides[1].radius, 2, exact);
            EXPECT_LT((section.sides[0].foremost - Vec3(section.place().x, 3, -3)).length(), exact);
            EXPECT_LT((section.outward - Vec3(0, 0, 1)).length(), exact);
        }
}

TEST(Joints, EndWhereTheShorterPanelEnds) {
    std::vector<Panel> panels = pair_of(4, 0);
    panels[1].origin.x = 33.3, panels[1].length = 100;
    const Joint joint = only_joint(model_of(panels));
    EXPECT_NEAR(joint.length, 100, exact);
    const auto [low, high] =
        std::minmax(joint.stations.front().place.x, joint.stations.back().place.x);
    EXPECT_NEAR(low, 33.3, exact);
    EXPECT_NEAR(high, 133.3, exact);
}

TEST(Joints, AreTheSameWhateverTheRollsSweep) {
    for (const double sweep : {1.0, 1.3, quarter_turn, 2.0, std::numbers::pi}) {
        std::vector<Panel> panels = pair_of(4, 0.5);
        for (Panel& panel : panels) panel.sweep = sweep;
        const double short_by = sweep < quarter_turn ? 5 * (1 - std::sin(sweep)) : 0;
        expect_constant(only_joint(model_of(panels)), 4 + short_by, 0.5);
    }
}

TEST(Joints, OfSharpEdgesHaveNoRadius) {
    for (const double flange : {0.0, 10.0}) {
        std::vector<Panel> panels = pair_of(4, 0.3);
        for (Panel& panel : panels) panel.radius = 0, panel.sweep = quarter_turn;
        for (Panel& panel : panels) panel.flange = flange;
        const Joint joint = only_joint(model_of(panels));
        expect_constant(joint, 9, 0.3);
        EXPECT_EQ(joint.extremes->sharpest.least_radius(), 0);
    }
}

TEST(Joints, TakeTheOutsideFromWhatLiesBeyondTheSkins) {
    std::vector<Panel> panels = pair_of(4, 0.3);
    for (Panel& panel : panels) panel.outward = {0, 0, -1};
    expect_constant(only_joint(model_of(panels)), 4, -0.3);
}

TEST(Joints, OfTiltedPanelsAreMeasuredAlongTheMeanOfTheirSkins) {
    for (const double degrees : {-30.0, -5.0, 1.0, 20.0}) {
        std::vector<Panel> panels = pair_of(4, 0.4);
        const double tilt = degrees_to_radians(degrees);
        panels[1].forward = {0, -std::cos(tilt), -std::sin(tilt)};
        panels[1].outward = {0, -std::sin(tilt), std::cos(tilt)};
        const Vec3 across(0, std::cos(tilt / 2), std::sin(tilt / 2));
        const Vec3 outward(0, -std::sin(tilt / 2), std::cos(tilt / 2));
        const double gap = (panels[1].foremost(-across) - panels[0].foremost(across)).dot(across);
        const double flush = (panels[1].origin - panels[0].origin).dot(outward);
        expect_constant(only_joint(model_of(panels)), gap, flush);
    }
}

TEST(Joints, ThatTaperAreMeasuredSquareToTheMeanOfTheirBorders) {
    for (const double degrees : {-1.0, 0.2, 3.0}) {
        std::vector<Panel> panels = pair_of(5, 0.4);
        const double taper = degrees_to_radians(degrees), half = taper / 2;
        panels[1].along = {std::cos(taper), std::sin(taper), 0};
        panels[1].forward = {std::sin(taper), -std::cos(taper), 0};
        const Joint joint = only_joint(model_of(panels));
        // Both foremost lines meet in `tip`, and the gap is 2 tan(half) of the way from there.
        const Vec3 mean(std::cos(half), std::sin(half), 0);
        const Vec3 on_second = panels[1].origin + panels[1].forward * 2;
        const Vec3 tip(on_second.x - (on_second.y - 3) / std::tan(taper), 3, 0);
        for (const JointStation& station : joint.stations) {
            ASSERT_TRUE(station.section);
            const double way = (station.place - tip).dot(mean);
            EXPECT_NEAR(station.section->gap, 2 * std::tan(half) * way, exact);
            EXPECT_NEAR(station.section->flush, 0.4, exact);
            EXPECT_NEAR(station.section->sides[0].radius, 3, exact);
        }
        const auto& sections = *joint.extremes;
        const double ends =
            std::abs(joint.stations.front().section->gap - joint.stations.back().section->gap);
        EXPECT_NEAR(sections.widest.gap - sections.narrowest.gap, ends, exact);
    }
}

TEST(Joints, AlongACylinderAreFlushWhereBothSkinsLieOnIt) {
    for (const double radius : {100.0, 1200.0})
        for (const double rise : {0.0, 0.25}) {
            std::vector<Panel> panels = pair_of(4, 0);
            const double turn = 9 / radius;
            panels[0].skin_radius = panels[1].skin_radius = radius;
            panels[1].origin =
                Vec3(0, std::sin(turn), std::cos(turn)) * (radius + rise) - Vec3(0, 0, radius);
            panels[1].outward = {0, std::sin(turn), std::cos(turn)};
            panels[1].forward = {0, -std::cos(turn), std::sin(turn)};
            const Vec3 across(0, std::cos(turn / 2), -std::sin(turn / 2));
            const double gap =
                (panels[1].foremost(-across) - panels[0].foremost(across)).dot(across);
            expect_constant(only_joint(model_of(panels)), gap, rise * std::cos(turn / 2));
        }
}

/// Profiles of a panel turned by 60 degrees about the line y = any, z = -radius, along x.
void add_revolved(test::ModelBuilder& builder, const Panel& panel, double radius) {
    const double angle = degrees_to_radians(60), w = std::cos(angle / 2);
    for (const auto& profile : profiles(panel)) {
        std::vector<Vec4> points;
        const auto add = [&](double at, double stretch, double weight) {
            for (const Vec4& p : profile) {
                const double r = (p.z + radius * p.w) * stretch * weight;
                points.emplace_back(r * std::sin(at), p.y * weight,
                                    r * std::cos(at) - radius * p.w * weight, p.w * weight);
            }
        };
        add(0, 1, 1), add(angle / 2, 1 / w, w), add(angle, 1, 1);
        builder.rational_patch(2, static_cast<int>(profile.size()) - 1, points);
    }
}

TEST(Joints, RoundACylinderHaveTheAxialGap) {
    for (const double flush : {0.0, -0.6}) {
        test::ModelBuilder builder;
        for (const Panel& panel : pair_of(4, flush)) add_revolved(builder, panel, 300);
        const Joint joint = only_joint(builder.build());
        expect_constant(joint, 4, flush);
        EXPECT_NEAR(joint.length, 300 * degrees_to_radians(60), exact);
        EXPECT_NEAR(joint.extremes->sharpest.least_radius(), 2, exact);
    }
}

/// A sheet along y = 0 and one whose border is `height` mm away at x = 100 and bends away from it.
SurfaceModel bowed(double height, double bow) {
    test::ModelBuilder builder;
    builder.plane({0, -60, 0}, {200, 0, 0}, {0, 60, 0});
    builder.patch(2, 1,
                  {{0, height + bow, 0},
                   {0, 60, 0},
                   {100, height - bow, 0},
                   {100, 60, 0},
                   {200, height + bow, 0},
                   {200, 60, 0}});
    return builder.build();
}

TEST(Joints, FindTheNarrowestPlaceBetweenSections) {
    JointLimits limits;
    limits.spacing = 23;
    const Joint joint = only_joint(bowed(4, 1.5), limits);
    EXPECT_NEAR(joint.extremes->narrowest.gap, 4, exact);
    EXPECT_NEAR(joint.extremes->narrowest.place().x, 100, 1e-2);
    // At the ends the chord is square to the mean of both directions.
    EXPECT_GT(joint.extremes->widest.gap, 5.4);
    EXPECT_GT(joint.extremes->hidden_gap, 0);
}

TEST(Joints, HaveChordsSquareToTheMeanOfBothBorders) {
    for (const JointStation& station : only_joint(bowed(4, 1.5)).stations) {
        ASSERT_TRUE(station.section);
        const JointSection& s = *station.section;
        const double x = s.sides[1].border.x, slope = (x - 100) * 1.5 / 5000;
        const Vec3 mean = Vec3(1, 0, 0) + Vec3(1, slope, 0).normalized();
        EXPECT_NEAR((s.sides[1].border - s.sides[0].border).dot(mean), 0, exact);
        EXPECT_NEAR(s.gap, (s.sides[1].border - s.sides[0].border).length(), exact);
    }
}

TEST(Joints, AreNoneOfOneBodyNorOfPanelsTooFarApart) {
    EXPECT_TRUE(joints_of(model_of({Panel{}})).empty());
    EXPECT_TRUE(joints_of(model_of(pair_of(15.1, 0))).empty());
    Panel left, right;
    left.flange = right.flange = left.radius = right.radius = 0;
    right.forward = {0, -1, 0}, right.origin = {0, 0.01, 0};
    EXPECT_TRUE(joints_of(model_of({left, right})).empty()) << "a closed seam";
}

TEST(Joints, AreNoneOfSheetsOverEachOther) {
    Panel below, above;
    above.origin = {0, 0, 5};
    EXPECT_TRUE(joints_of(model_of({below, above})).empty());
}

TEST(Joints, OfARolledEdgeAndTheSharpSideOfAnotherPanel) {
    Panel rolled, square;
    square.along = {0, 1, 0}, square.forward = {-1, 0, 0}, square.origin = {0, 12, 0};
    const Joint joint = only_joint(model_of({rolled, square}));
    expect_constant(joint, 9, 0);
    EXPECT_NEAR(joint.length, 60, exact);
    EXPECT_NEAR(joint.stations.front().section->sides[0].radius, 3, exact);
    EXPECT_EQ(joint.stations.front().section->sides[1].radius, 0);
}

TEST(Joints, OfThreePanelsAtACornerAreThree) {
    // A long panel, and two across it whose joint runs square to its border.
    std::vector<Panel> panels = pair_of(4, 0);
    panels[1].length = 90;
    Panel third = panels[1];
    third.origin.x = 100, third.length = 100;
    SurfaceModel model;
    {
        test::ModelBuilder builder;
        for (Panel panel : {panels[0], panels[1], third}) {
            panel.radius = panel.flange = 0;
            add(builder, panel);
        }
        model = builder.build();
    }
    std::vector<Joint> joints = joints_of(model);
    std::sort(joints.begin(), joints.end(),
              [](const Joint& a, const Joint& b) { return a.length < b.length; });
    ASSERT_EQ(joints.size(), 3u);
    EXPECT_NEAR(joints[0].length, 60, exact);
    EXPECT_NEAR(joints[0].extremes->widest.gap, 10, exact);
    EXPECT_NEAR(joints[1].length, 90, exact);
    EXPECT_NEAR(joints[1].extremes->widest.gap, 9, exact);
    EXPECT_NEAR(joints[2].length, 100, exact);
    EXPECT_NEAR(joints[2].extremes->narrowest.gap, 9, exact);
}

TEST(Joints, DoNotReachOverAPanelBetweenTwoOthers) {
    std::vector<Panel> panels = pair_of(10, 0);
    for (Panel& panel : panels) panel.radius = panel.flange = 0;
    Panel strip = panels[1];
    strip.origin = {0, 4, 0}, strip.depth = 5;
    panels.push_back(strip);
    const std::vector<Joint> joints = joints_of(model_of(panels));
    ASSERT_EQ(joints.size(), 2u);
    EXPECT_NEAR(joints[0].extremes->widest.gap, 4, exact);
    EXPECT_NEAR(joints[1].extremes->widest.gap, 6, exact);
}

/// A sheet below y = 0 and one above `gap` whose corner at x = 200 is round.
SurfaceModel rounded_corner(double gap, double radius) {
    const auto arc = [&](double from_x, double from_y, double corner_x, double corner_y,
                         double to_x, double to_y) {
        const double w = std::sqrt(0.5);
        return test::CurveData{
            {Vec3(from_x, from_y, 1), Vec3(corner_x * w, corner_y * w, w), Vec3(to_x, to_y, 1)}};
    };
    test::ShapeBuilder builder;
    builder.face({test::rectangle(0, 200, -60, 0, 0)});
    builder.face({test::rectangle(0, 200, gap, 80, 0)},
                 {{test::line({0, gap}, {200 - radius, gap}),
                   arc(200 - radius, gap, 200, gap, 200, gap + radius),
                   test::line({200, gap + radius}, {200, 80}), test::line({200, 80}, {0, 80}),
                   test::line({0, 80}, {0, gap})}});
    return builder.model();
}

TEST(Joints, EndWhereACornerBegins) {
    for (const double radius : {5.0, 40.0}) {
        const Joint joint = only_joint(rounded_corner(4, radius));
        expect_constant(joint, 4, 0);
        EXPECT_NEAR(joint.length, 200 - radius, exact);
    }
    EXPECT_GT(only_joint(rounded_corner(4, 130)).extremes->widest.gap, 4.5) << "no corner";
}

TEST(Joints, RoundAFlapAreClosed) {
    test::ShapeBuilder builder;
    builder.face({test::rectangle(-60, 60, -60, 60, 0.3)}, {test::circle({0, 0}, 50)});
    builder.face({test::rectangle(-150, 150, -150, 150, 0)},
                 {test::polygon({{-150, -150}, {150, -150}, {150, 150}, {-150, 150}}),
                  test::circle({0, 0}, 54)});
    const Joint joint = only_joint(builder.model());
    EXPECT_TRUE(joint.closed);
    expect_constant(joint, 4, -0.3);
    EXPECT_NEAR(joint.length, 2 * std::numbers::pi * 50, exact);
}

/// Gaps, flushes and radii of a tapered joint of mixed rolls, placed by a motion.
Joint placed_joint(const Affine& motion, bool reordered) {
    std::vector<Panel> panels = pair_of(5, 0.4);
    panels[1].along = Vec3(1, 0.01, 0).normalized();
    panels[1].forward = Vec3(0.01, -1, 0).normalized();
    test::ModelBuilder builder;
    std::vector<std::vector<Vec4>> of_first = profiles(panels[0]), of_second = profiles(panels[1]);
    if (reordered) {
        extruded(builder, of_first[2], panels[0].along * 200);
        extruded(builder, of_second[1], panels[1].along * 200);
        extruded(builder, of_first[0], panels[0].along * 200);
        extruded(builder, of_second[0], panels[1].along * 200);
        extruded(builder, of_first[1], panels[0].along * 200);
        extruded(builder, of_second[2], panels[1].along * 200);
    } else {
        add(builder, panels[0]), add(builder, panels[1]);
    }
    builder.instance(motion);
    return only_joint(builder.build());
}

TEST(Joints, KeepTheirValuesThroughMotionsAndOrders) {
    const double a = 0.7, b = -1.1;
    const Affine motion{{Vec3(std::cos(a), std::sin(a), 0),
                         Vec3(-std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)),
                         Vec3(std::sin(a) * std::sin(b), -std::cos(a) * std::sin(b), std::cos(b))},
                        {3000, -700, 900}};
    const JointExtremes still = *placed_joint({}, false).extremes;
    for (const bool reordered : {false, true}) {
        const JointExtremes moved = *placed_joint(motion, reordered).extremes;
        EXPECT_NEAR(moved.widest.gap, still.widest.gap, exact);
        EXPECT_NEAR(moved.narrowest.gap, still.narrowest.gap, exact);
        EXPECT_NEAR(moved.proudest.flush, still.proudest.flush, exact);
        EXPECT_NEAR(moved.sharpest.least_radius(), still.sharpest.least_radius(), exact);
        EXPECT_LT((moved.widest.place() - motion.point(still.widest.place())).length(), 1e-5);
    }
}

TEST(Joints, OfTheSecondPanelFirstHaveTheOppositeFlush) {
    std::vector<Panel> panels = pair_of(4, 0.4);
    std::swap(panels[0], panels[1]);
    expect_constant(only_joint(model_of(panels)), 4, -0.4);
}

} // namespace
} // namespace keiko
