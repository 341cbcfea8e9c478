#include "keiko/triage/fault_units.h"
#include "keiko/triage/reflection_break.h"
#include "keiko/triage/standing_eyes.h"
#include "keiko/triage/triage.h"

#include "tests/unit/triage/triaged_sheets.h"
#include <gtest/gtest.h>

#include <set>

namespace keiko {
namespace {

using test::bent_pair;
using test::curved_pair;
using test::holed_sheet;
using test::ModelBuilder;
using test::Triaged;

TEST(Triage, AFaultOverSeveralStretchesIsOneItem) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 900, 0.5, 3);
    const Triaged found(builder);
    ASSERT_EQ(found.inspection.findings.size(), 3u);
    ASSERT_EQ(found.triage.items.size(), 1u);
    const TriageItem& item = found.triage.items[0];
    EXPECT_EQ(item.seams.size(), 3u);
    EXPECT_EQ(found.inspection.findings.at(item.findings.front()).seam, item.seams.front());
    EXPECT_EQ(std::set<std::size_t>(item.findings.begin(), item.findings.end()),
              (std::set<std::size_t>{0, 1, 2}));
    EXPECT_NEAR(item.length, 900, 1e-6);
    EXPECT_FALSE(item.mirrored);
}

TEST(Triage, ImagesOfEachOtherAreOneItem) {
    ModelBuilder builder;
    bent_pair(builder, {0, 500, 0}, 400, 0.5);
    bent_pair(builder, {0, -500, 0}, 400, 0.52);
    bent_pair(builder, {600, 500, 0}, 400, 0.5);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 2u);
    EXPECT_TRUE(found.triage.items[0].mirrored);
    EXPECT_EQ(found.triage.items[0].seams.size(), 2u);
    EXPECT_FALSE(found.triage.items[1].mirrored);
}

TEST(Triage, LinesBelongToTheStretchThatTheyCross) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 100, 0.5);
    bent_pair(builder, {300, 0, 0}, 100, 0.4);
    const SurfaceModel model = builder.build();
    Inspection inspection = inspect(model);
    ASSERT_EQ(inspection.seams.size(), 2u);
    for (MeasuredSeam& seam : inspection.seams) seam.faces = "face 1 | face 2";
    Check line;
    line.code = "KEIKO-LINE-TURN", line.faces = "face 1 | face 2";
    line.worst.value = 0.4, line.worst.place = {350, 0, 0};
    inspection.findings.push_back(line);
    const Triage found = triage(model, Tracer(model), inspection, {});
    ASSERT_EQ(found.items.size(), 2u);
    for (const TriageItem& item : found.items)
        EXPECT_EQ(item.findings.size(), item.place.x < 200 ? 1u : 2u);
}

TEST(Triage, AStretchIsAsNearAsItsCourseIsNotItsPlaces) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 3000, 0.5);
    bent_pair(builder, {1200, 120, 400}, 10, 0.4);
    const SurfaceModel model = builder.build();
    Inspection inspection = inspect(model);
    ASSERT_EQ(inspection.seams.size(), 2u);
    for (MeasuredSeam& seam : inspection.seams) {
        seam.faces = "face 1 | face 2";
        seam.course = {{seam.course.front().front(), seam.course.back().back()}};
    }
    Check line;
    line.code = "KEIKO-LINE-TURN", line.faces = "face 1 | face 2";
    line.worst.value = 0.4, line.worst.place = {1200, 0, 0};
    inspection.findings.push_back(line);
    for (const TriageItem& item : triage(model, Tracer(model), inspection, {}).items)
        EXPECT_EQ(item.findings.size(), item.length > 1000 ? 2u : 1u);
}

TEST(Triage, WhatIsSeenFromTheTopAloneComesLast) {
    Sight standing, above, unseen;
    standing.weight[3] = 1, standing.weight.back() = 2;
    above.weight.back() = 1000;
    EXPECT_EQ(standing_views[standing.best_view()], "standing-right");
    EXPECT_EQ(standing_views[above.best_view()], "top");
    EXPECT_EQ(unseen.best_view(), 0u);
    EXPECT_TRUE(standing.is_worse_than(above));
    EXPECT_FALSE(above.is_worse_than(standing));
    EXPECT_TRUE(standing.is_worse_than(unseen));
}

TEST(Triage, ALineGoesOnWhereItsPatchesAreOutOfStep) {
    for (const auto& [step, items] : {std::pair(8.0, 1u), {30.0, 2u}}) {
        ModelBuilder builder;
        bent_pair(builder, {0, 0, 0}, 400, 0.5);
        bent_pair(builder, {403, step, 0}, 400, 0.3);
        EXPECT_EQ(Triaged(builder).triage.items.size(), items) << step;
    }
}

TEST(Triage, AHoleIsAFaultThoughItIsNotJudged) {
    ModelBuilder builder;
    holed_sheet(builder, {0, 0, 0});
    const Triaged found(builder);
    EXPECT_TRUE(found.inspection.findings.empty());
    ASSERT_EQ(found.inspection.looks.size(), 1u);
    ASSERT_EQ(found.triage.items.size(), 1u);
    const TriageItem& item = found.triage.items[0];
    EXPECT_EQ(item.mending, Mending::position);
    EXPECT_EQ(numbered_check(found.inspection, item.findings.at(0)).code, "KEIKO-OPENING");
    EXPECT_NEAR(item.width, lamp_width, 1e-9) << "as a gap far beyond its limit";
    EXPECT_NEAR((item.place - Vec3(105, 104, 0)).length(), 0, 1);
    EXPECT_GT(item.weight, 50);
}

TEST(Triage, AHoleBesideTheSkinIsMeant) {
    ModelBuilder builder;
    holed_sheet(builder, {0, 0, 0});
    bent_pair(builder, {1000, 0, 0}, 900, 0.5); // a larger skin
    const Triaged found(builder);
    EXPECT_EQ(found.inspection.looks.size(), 1u);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].mending, Mending::tangent);
}

TEST(Triage, HolesThatAreImagesAreOneItem) {
    ModelBuilder builder;
    for (const double y : {-400.0, 192.0}) holed_sheet(builder, {0, y, 0});
    builder.plane({0, -192, 0}, {210, 0, 0}, {0, 384, 0});
    const Triaged found(builder);
    EXPECT_EQ(found.inspection.looks.size(), 2u);
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_TRUE(found.triage.items[0].mirrored);
    EXPECT_EQ(found.triage.items[0].findings.size(), 2u);
}

TEST(Triage, WhatLiesInOneGlanceIsOneItem) {
    for (const auto& [apart, items] : {std::pair(35.0, 2u), {100.0, 3u}}) {
        ModelBuilder builder;
        bent_pair(builder, {0, 0, 0}, 20, 0.5);
        bent_pair(builder, {apart, 0, 0}, 20, 0.3);
        bent_pair(builder, {2000, 0, 0}, 20, 0.4);
        const Triaged found(builder);
        ASSERT_EQ(found.inspection.findings.size(), 3u);
        EXPECT_EQ(found.triage.items.size(), items) << apart << " mm apart";
    }
}

TEST(Triage, WhatIsMendedByOtherMeansIsOneItemWhereItTouches) {
    for (const auto& [from, items] : {std::pair(21.0, 1u), {40.0, 2u}}) {
        ModelBuilder builder;
        builder.plane({0, 0, 0}, {20, 0, 0}, {0, 100, 0});
        builder.plane({0, -0.05, 0}, {20, 0, 0}, {0, -100, 0});
        bent_pair(builder, {from, 0, 0}, 10, 0.2);
        bent_pair(builder, {2000, 0, 0}, 20, 0);
        const Triaged found(builder);
        ASSERT_EQ(found.inspection.findings.size(), 2u);
        ASSERT_EQ(found.triage.items.size(), items) << from;
        EXPECT_EQ(found.triage.items[0].mending, Mending::position);
    }
}

TEST(Triage, AStretchWithAGapAsksForPositionThoughItsAngleIsWorse) {
    ModelBuilder builder;
    builder.plane({0, 0, 0}, {200, 0, 0}, {0, 100, 0});
    builder.plane({0, -0.02, 0}, {200, 0, 0}, {0, -100, -3});
    const Triaged found(builder);
    ASSERT_EQ(found.inspection.findings.size(), 2u);
    EXPECT_EQ(found.inspection.findings[0].code, "G-SU-NT");
    ASSERT_EQ(found.triage.items.size(), 1u);
    EXPECT_EQ(found.triage.items[0].mending, Mending::position);
}

TEST(Triage, ATornTipOfALongLineIsAnItemOfItsOwn) {
    ModelBuilder builder;
    bent_pair(builder, {0, 0, 0}, 800, 0.2);
    bent_pair(builder, {801, 0, 0}, 10, 1.5);
    const Triaged found(builder);
    ASSERT_EQ(found.inspection.findings.size(), 2u);
    EXPECT_EQ(found.triage.items.size(), 2u);
}

TEST(Triage, JumpsTooFineForAnEyeAreOneItem) {
    constexpr double fillet = -1.0 / 15, panel = -1.0 / 2000;
    ModelBuilder builder;
    curved_pair(builder, {0, 0, 0}, 0, fillet);
    curved_pair(builder, {2000, 0, 0}, 0, fillet);
    curved_pair(builder, {0, 1000, 0}, 0, panel);
    const Triaged found(builder);
    ASSERT_EQ(found.triage.items.size(), 2u);
    for (const TriageItem& item : found.triage.items) {
        EXPECT_EQ(item.seams.size(), item.fine ? 2u : 1u);
        EXPECT_EQ(item.fine, item.width < eye_resolution);
    }
    EXPECT_FALSE(found.triage.items[0].fine);
    EXPECT_TRUE(found.triage.items[1].fine);
}

TEST(Triage, WhatNoEyeResolvesClosesTheFirstFaultsIfItPrevails) {
    TriageItem fault;
    fault.seams = {0};
    for (const auto& [stretches, at] : {std::pair(std::size_t(10), most_shown - 1), {9, 8}}) {
        std::vector<TriageItem> faults(10, fault);
        for (std::size_t i = 0; i < faults.size(); ++i) faults[i].length = double(i);
        faults[8].fine = true, faults[8].seams.assign(stretches, 0); // beside nine others
        put_fine_among_first(faults);
        ASSERT_TRUE(faults[at].fine) << stretches;
        std::vector<double> others;
        for (const TriageItem& any : faults)
            if (!any.fine) others.push_back(any.length);
        EXPECT_EQ(others, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 9})) << "keep their order";
    }
    std::vector<TriageItem> first(3, fault), none;
    first[1].fine = true, first[1].seams.assign(9, 0);
    put_fine_among_first(first);
    EXPECT_TRUE(first[1].fine) << "already among them";
    put_fine_among_first(none);
    EXPECT_TRUE(none.empty());
}

TEST(FaultUnits, OnlyJumpsOfCurvatureAreTooFine) {
    for (const auto& [code, fine] : {std::pair("KEIKO-G3", false), {"G-SU-NS", true}}) {
        Inspection inspection;
        inspection.seams.emplace_back();
        Check check;
        check.code = code, check.seam = 0;
        inspection.findings.push_back(check);
        std::vector<FaultUnit> units = fault_units(inspection);
        ASSERT_EQ(units.size(), 1u);
        units[0].sight.length = units[0].sight.visible = 1;
        EXPECT_EQ(units[0].is_fine(), fine) << code;
    }
}

TEST(Triage, ARowOfFaultsIsNotOneItem) {
    ModelBuilder builder;
    for (int i = 0; i < 8; ++i) bent_pair(builder, {40.0 * i, 0, 0}, 10, 0.5);
    bent_pair(builder, {2000, 0, 0}, 10, 0);
    const Triaged found(builder);
    ASSERT_EQ(found.inspection.findings.size(), 8u);
    EXPECT_GE(found.triage.items.size(), 3u);
    for (const TriageItem& item : found.triage.items) EXPECT_LE(item.seams.size(), 3u);
}

} // namespace
} // namespace keiko
