#include "keiko/triage/triage.h"

#include "keiko/base/units.h"
#include "keiko/triage/reflection_break.h"
#include "keiko/triage/seam_sight.h"

#include "tests/unit/triage/triaged_sheets.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using test::bent_pair;
using test::closed_box;
using test::curved_pair;
using test::ModelBuilder;
using test::Triaged;

TEST(Triage, OrdersFaultsByWhatIsSeen) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 400, 0.3);
    bent_pair(builder, {0, 1000, 0}, 400, 0.9);
    bent_pair(builder, {0, 2000, 0}, 20, 2); // short
    bent_pair(builder, {0, 3000, 0}, 400, 0.05);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 3u);
    EXPECT_TRUE(found.triage.hidden.empty());
    EXPECT_NEAR(found.angle_of(found.triage.items[0]), 0.9, 1e-9);
    // 20 mm of 2 degrees weigh as 400 mm of 2 / 20^(1/3), or 0.74 degrees.
    EXPECT_NEAR(found.angle_of(found.triage.items[1]), 2, 1e-9);
    EXPECT_NEAR(found.angle_of(found.triage.items[2]), 0.3, 1e-9);
    for (const TriageItem& item : found.triage.items) {
        EXPECT_EQ(item.mending, Mending::tangent);
        EXPECT_NEAR(item.width, 60 * 2 * found.angle_of(item), 1e-6) << "of plane sheets";
        EXPECT_EQ(item.visible, 1);
        EXPECT_NEAR(item.length, found.inspection.seams[item.seams.front()].length, 1e-6);
    }
}

TEST(Triage, FaultsInsideABoxAreHidden) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 300, 0.5);
    closed_box(builder, {-100, -200, -100}, {500, 400, 200});
    bent_pair(builder, {1000, 0, 0}, 300, 0.5);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    ASSERT_EQ(found.triage.hidden.size(), 1u);
    EXPECT_EQ(found.triage.hidden[0].visible, 0);
    EXPECT_EQ(found.triage.hidden[0].weight, 0);
    const Vec3 place = found.triage.items[0].place;
    EXPECT_GE(place.x, 1000);
}

/// A break of 60 arc minutes along a length weighs as along a degree by the cube root of the
/// length.
TEST(Triage, WeightsArePooledAlongTheLength) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 100, 0.5);
    const SurfaceModel model = builder.build();
    const Inspection inspection = inspect(model);
    const Tracer tracer(model);
    const std::vector<std::uint32_t> first{0};
    const Sight sight = FindingSights(model, tracer, inspection).of_stretches(first)[0];
    const Triage found = triage(model, tracer, inspection, {});
    ASSERT_EQ(found.items.size(), 1u);
    EXPECT_EQ(found.items[0].weight, break_of_pooled(sight.weight[sight.best_view()]));
    // From 3 to 6 m, 100 mm are seen in at most 60 x 57.3 x 100 / 3000 arc minutes.
    EXPECT_LT(found.items[0].weight, 60 * std::cbrt(115 / 60.0));
    EXPECT_GT(found.items[0].weight, 60 * std::cbrt(57 / 60.0));
}

TEST(Triage, CreasesCountByTheirGapAlone) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 100, 0});
    builder.plane({0, 0, -0.05}, {300, 0, 0}, {0, 0, -100});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].mending, Mending::position);
    // The limit of 0.01 mm is exceeded by four times itself, which counts as half of four times 0.1
    // degrees.
    EXPECT_NEAR(found.triage.items[0].width, break_of_angle(0.4, 0, {3000, 1}) / 2, 1e-6);
}

TEST(Triage, AGapWithinItsLimitHasNoPartInTheOrder) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 100, 0});
    builder.plane({0, -0.009, 0}, {300, 0, 0}, {0, -100, -0.4});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].mending, Mending::tangent);
    EXPECT_NEAR(found.triage.items[0].width, 60 * 2 * found.angle_of(found.triage.items[0]), 1e-6);
}

/// Two sheets that stand on the floor, bent by 3 degrees to bulge towards y > 0 or y < 0.
void standing_pair(ModelBuilder& builder, double side, bool turned) {
    const Vec3 along = Vec3(turned ? -400 : 400, 0, 0), from(turned ? 400 : 0, 500 * side, 100);
    const double turn = degrees_to_radians(3), height = 100;
    builder.plane(from, along, {0, 0, -height});
    builder.plane(from, along, Vec3(0, -side * std::sin(turn), std::cos(turn)) * height);
}

TEST(Triage, EyesLookAtThePanelFromTheSideToWhichItBulges) {
    for (const double side : {1.0, -1.0})
        for (const bool turned : {true, false}) {
            ModelBuilder builder;
            standing_pair(builder, side, turned);
            const SurfaceModel model = builder.build();
            const Inspection inspection = inspect(model);
            const Tracer tracer(model);
            const std::vector<std::uint32_t> first{0};
            const Sight sight = FindingSights(model, tracer, inspection).of_stretches(first)[0];
            for (std::size_t i = 0; i < standing_views.size(); ++i) {
                const bool right = standing_views[i].find("right") != std::string_view::npos;
                const bool left = standing_views[i].find("left") != std::string_view::npos;
                if (side > 0 ? right : left) {
                    EXPECT_GT(sight.weight[i], 0) << standing_views[i];
                }
                if (side > 0 ? left : right) {
                    EXPECT_EQ(sight.weight[i], 0) << standing_views[i];
                }
            }
            EXPECT_NEAR(sight.visible, sight.length, 1e-9);
        }
}

TEST(Triage, AChangeIsNoWiderThanTheSeamIsLong) {
    ModelBuilder builder;
    std::vector<Vec3> points;
    for (const double side : {-1.0, 1.0}) {
        points.clear();
        for (const double x : {0.0, 10.0})
            for (const double share : {0.0, 0.5, 1.0})
                points.emplace_back(x, 100 * side * share,
                                    share == 1 ? side * 100 * 100 / 4000 : 0);
        builder.patch(1, 2, points);
    }
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_LE(found.triage.items[0].width, 60 * radians_to_degrees(10 / 3000.0));
    EXPECT_GT(found.triage.items[0].width, 60 * radians_to_degrees(10 / 8000.0));
}

/// Its outer side faces the floor: what the eyes see counts.
TEST(Triage, ADishIsLookedInto) {
    ModelBuilder builder;
    curved_pair(builder, {0, 0, 0}, 1 / 2000.0, 1 / 1000.0);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].visible, 1);
}

TEST(Triage, TheMiddleOfAnEvenFaultIsItsPlace) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 400, 0.5);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_NEAR(found.triage.items[0].place.x, 200, 40);
}

/// The only fault of a pair of sheets of these radii in mm; above 0: hollow from above.
TriageItem fault_of_radii(double before, double after) {
    ModelBuilder builder;
    curved_pair(builder, {0, 0, 0}, 1 / before, 1 / after);
    const Triaged found(builder);
    EXPECT_EQ(found.triage.items.size(), 1u);
    return found.triage.items.empty() ? TriageItem() : found.triage.items[0];
}

TEST(Triage, ACurvatureThatChangesItsSignIsSeen) {
    const TriageItem item = fault_of_radii(2000, -2000);
    EXPECT_EQ(item.mending, Mending::curvature);
    // A standing eye is 3.5 m away and sees it at c = 0.47: 1 / (1 + 7.4) and 1 / (1 - 7.4).
    EXPECT_NEAR(item.width, 0.275 * lamp_width, 0.01 * lamp_width);
    EXPECT_GT(item.weight, 3);
}

TEST(Triage, AHollowPlaceBreaksMoreThanABulgedOne) {
    // By the formula 0.21 and 0.09 of a lamp's width.
    EXPECT_GT(fault_of_radii(2000, 4000).width, 1.6 * fault_of_radii(-2000, -4000).width);
    EXPECT_NEAR(fault_of_radii(-4000, -2000).width, fault_of_radii(-2000, -4000).width, 1e-6);
}

TEST(Triage, FindingsOfAFaceCountByWhatTheyAskFor) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {300, 0, 0}, {0, 300, 0});
    const SurfaceModel model = builder.build();
    Inspection inspection = inspect(model);
    const auto add = [&](const char* code, const char* unit, const Vec3& place) {
        Check check;
        check.code = code, check.unit = unit, check.faces = "face 1";
        check.face = 0, check.worst.place = place;
        inspection.findings.push_back(check);
    };
    Flaw dent;
    dent.width = 60, dent.depth.value = 0.2, dent.depth.place = {150, 150, 0};
    inspection.faces[0].flaws.push_back(dent);
    add("G-CU-TI", "mm", {10, 10, 0}); // of the structure, where no eye sees anything of it
    add("KEIKO-DENT", "mm", dent.depth.place);
    const Triage found = triage(model, Tracer(model), inspection, {});
    ASSERT_EQ(found.items.size(), 2u);
    EXPECT_EQ(found.items[0].mending, Mending::curvature);
    EXPECT_EQ(found.items[0].findings, std::vector<std::size_t>{1});
    EXPECT_GT(found.items[0].weight, 50);
    EXPECT_EQ(found.items[1].mending, Mending::layout);
    EXPECT_EQ(found.items[1].weight, 0);
}

TEST(Triage, EyesStandOnTheGround) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 1000}, 400, 0.5);
    const SurfaceModel model = builder.build();
    const Inspection inspection = inspect(model);
    const Tracer tracer(model);
    const std::vector<std::uint32_t> first{0};
    const auto sight = [&](std::optional<double> ground) {
        return FindingSights(model, tracer, inspection, ground).of_stretches(first)[0];
    };
    const Sight in_vehicle = sight({}), on_ground = sight(0.0), raised = sight(1000.0);
    EXPECT_EQ(in_vehicle.weight, on_ground.weight) << "a panel above z = 0 is part of a vehicle";
    // The surface lies 650 mm below the eyes rather than 1650: it is seen nearer, at a flatter
    // angle.
    for (std::size_t view = 0; view < 4; ++view)
        EXPECT_GT(std::abs(on_ground.weight[view] - raised.weight[view]),
                  0.01 * raised.weight[view])
            << standing_views[view];
    EXPECT_EQ(on_ground.weight.back(), raised.weight.back()) << "from above";
}

TEST(Triage, ATearIsSeenSoonerThanAChangeOfWidth) {
    ModelBuilder builder;
    curved_pair(builder, {0, 0, 0}, -1 / 2000.0, -1 / 8000.0);
    bent_pair(builder, {1000, 0, 0}, 400, 0.12);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 2u);
    const TriageItem &first = found.triage.items[0], &second = found.triage.items[1];
    EXPECT_EQ(first.mending, Mending::tangent);
    EXPECT_LT(first.width, 2 * second.width) << "arc minutes, of either break";
    EXPECT_GT(first.weight, 6 * second.weight);
}

/// A crease that falls from 20 degrees to 2.4 and ends there: the end of it is the fault.
TEST(Triage, ACreaseThatDoesNotFadeOutCountsByWhatIsLeft) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {400, 0, 0}, {0, 100, 0});
    const auto down = [](double degrees) { return 100 * std::tan(degrees_to_radians(degrees)); };
    builder.patch(1, 1, {{0, 0, 0}, {0, -100, -down(20)}, {400, 0, 0}, {400, -100, -down(2.4)}});
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_NEAR(found.angle_of(found.triage.items[0]), 5, 0.01) << "where it is no crease any more";
    EXPECT_NEAR(found.triage.items[0].width, 60 * 2 * 2.4, 3);
    EXPECT_GT(found.triage.items[0].place.x, 385);
    EXPECT_NEAR(found.triage.items[0].left_of_crease, 2.4, 1e-3);
}

TEST(StandingEyes, DoNotResolveStripesAcrossASmallFillet) {
    ModelBuilder builder;
    builder.plane({-200, -200, 0}, {400, 0, 0}, {0, 400, 0});
    const SurfaceModel model = builder.build();
    const Tracer tracer(model);
    const StandingEyes eyes(tracer);
    SightPlace at;
    at.place = {0, 0, 1}, at.normal = {0, 0, 1}, at.along = {1, 0, 0}, at.length = 1000;
    at.curvature_a = -1 / 2000.0;
    const Sight straight = eyes.sight(std::span(&at, 1));
    at.curvature_along = -1 / 2000.0;
    EXPECT_EQ(eyes.sight(std::span(&at, 1)).tear, straight.tear) << "stripes of several minutes";
    at.curvature_along = -1 / 20.0;
    const Sight fillet = eyes.sight(std::span(&at, 1));
    EXPECT_EQ(fillet.width, straight.width) << "it changes as much, and is seen less";
    EXPECT_LT(fillet.tear, 0.5 * straight.tear);
    EXPECT_GT(fillet.tear, 0);
    at.angle = 1;
    EXPECT_GT(eyes.sight(std::span(&at, 1)).tear, straight.tear) << "a tear is seen all the same";
}

TEST(Triage, OfABodyWithoutFindingsIsEmpty) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 400, 0);
    const Triaged found(builder);
    EXPECT_TRUE(found.triage.items.empty());
    EXPECT_TRUE(found.triage.hidden.empty());
}

} // namespace
} // namespace keiko
