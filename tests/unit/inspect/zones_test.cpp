// Faces and seams judged by the limits of their zones, and the part of a body that is judged.

#include "keiko/base/units.h"
#include "keiko/inspect/inspection.h"
#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_profile.h"
#include "keiko/scene/stricter_limits.h"

#include "tests/support/random.h"
#include "tests/unit/inspect/dented_panel.h"
#include "tests/unit/inspect/notched_sheets.h"
#include "tests/unit/inspect/sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace keiko {
namespace {

using test::ModelBuilder;

/// Strips beside each other across y, each tilted by its number of `degrees` against the one
/// before.
SurfaceModel strips(const std::vector<double>& degrees, double gap = 0) {
    ModelBuilder builder;
    Vec3 from(0);
    double tilt = 0;
    for (std::size_t i = 0; i <= degrees.size(); ++i) {
        const Vec3 across(0, 20 * std::cos(tilt), -20 * std::sin(tilt));
        test::flat_sheet(builder, across, from);
        from += across + Vec3(0, gap, 0);
        if (i < degrees.size()) tilt += degrees_to_radians(degrees[i]);
    }
    return builder.build();
}

/// A zone with its limits.
Zone zone(const std::string& name, const CriteriaPreset& limits) {
    Zone zone;
    zone.name = name, zone.selection.faces = {"*"}, zone.limits = limits;
    return zone;
}

CriteriaPreset with_angle(double degrees) {
    CriteriaPreset preset;
    preset.angle = degrees;
    return preset;
}

FaceLimits limits(const SurfaceModel& model, CriteriaPreset preset, std::vector<Zone> zones,
                  std::vector<std::uint32_t> zone_of) {
    preset.zones = std::move(zones);
    return {model, std::move(preset), {.zone = std::move(zone_of), .in_scope = {}, .scope = ""}};
}

Inspection in_scope(const SurfaceModel& model, std::vector<bool> faces,
                    const CriteriaPreset& preset = {}) {
    FaceZones zones;
    zones.zone.assign(faces.size(), no_zone);
    zones.in_scope = std::move(faces), zones.scope = "these";
    return inspect(model, {model, preset, std::move(zones)});
}

TEST(Zones, JudgeTheirSeamsAndLeaveTheOthersToTheStricterLimit) {
    const SurfaceModel model = strips({0.15, 0.15, 0.15});
    const Inspection result =
        inspect(model, limits(model, {}, {zone("B", with_angle(0.2))}, {no_zone, no_zone, 0, 0}));
    EXPECT_EQ(result.counts, (SeamCounts{.fail = 2, .undecided = 0, .pass = 1}));
    ASSERT_EQ(result.seams.size(), 3u);
    EXPECT_EQ(result.seams[1].verdict, Verdict::fail) << "a face of B and one of none";
    EXPECT_EQ(result.seams[1].angle->limit, 0.1);
    EXPECT_EQ(result.seams[2].verdict, Verdict::pass);
    EXPECT_EQ(result.seams[2].angle->limit, 0.2);
    ASSERT_TRUE(result.scope);
    ASSERT_EQ(result.scope->zones.size(), 1u);
    const ZoneFacts& b = result.scope->zones[0];
    EXPECT_EQ(b.faces, 2u);
    EXPECT_EQ(b.looser, std::vector<std::string>{"angle 0.2 degrees instead of 0.1 degrees"});
    EXPECT_EQ(b.excused_seams, 1u) << "by the preset itself it fails";
    EXPECT_EQ(result.scope->zoneless, 2u);
}

TEST(Zones, FailWhatThePresetItselfPasses) {
    const SurfaceModel model = strips({0.05, 0.05, 0.05});
    const Inspection result = inspect(
        model, limits(model, {}, {zone("A", with_angle(0.01))}, {0, no_zone, no_zone, no_zone}));
    EXPECT_EQ(result.counts, (SeamCounts{.fail = 1, .undecided = 0, .pass = 2}));
    EXPECT_EQ(result.findings.at(0).faces, "face 1 | face 2");
    EXPECT_TRUE(result.scope->zones[0].looser.empty());
    EXPECT_EQ(result.scope->zones[0].excused_seams, 0u);
}

TEST(Zones, HoldASeamBetweenThemToTheStricterOfEachCriterion) {
    CriteriaPreset tight_gap = with_angle(0.5), tight_angle = with_angle(0.05);
    tight_gap.gap = 0.001, tight_angle.gap = 0.05;
    const SurfaceModel model = strips({0.08}, 0.005);
    const Inspection result = inspect(
        model, limits(model, {}, {zone("gap", tight_gap), zone("angle", tight_angle)}, {0, 1}));
    ASSERT_EQ(result.seams.size(), 1u);
    EXPECT_EQ(result.seams[0].gap.limit, 0.001);
    EXPECT_EQ(result.seams[0].gap.verdict, Verdict::fail);
    EXPECT_EQ(result.seams[0].angle->limit, 0.05);
    EXPECT_EQ(result.seams[0].angle->verdict, Verdict::fail);
}

TEST(Zones, JudgeFacesByThemselves) {
    ModelBuilder builder;
    builder.rational_patch(1, 2, test::arc_sheet(0, 10, 0, 1));
    builder.rational_patch(1, 2, test::arc_sheet(500, 10, 0, 1));
    const SurfaceModel model = builder.build();
    CriteriaPreset preset, tight, loose;
    preset.surface.minimum_radius = 8, tight.surface.minimum_radius = 12;
    const Inspection fails =
        inspect(model, limits(model, preset, {zone("A", tight)}, {no_zone, 0}));
    EXPECT_EQ(fails.face_counts, (FaceCounts{.fail = 1, .undecided = 0, .pass = 1}));
    EXPECT_EQ(fails.faces[1].verdict, Verdict::fail);
    preset.surface.minimum_radius = 12;
    const Inspection passes =
        inspect(model, limits(model, preset, {zone("C", loose)}, {no_zone, 0}));
    EXPECT_EQ(passes.faces[0].verdict, Verdict::fail);
    EXPECT_EQ(passes.faces[1].verdict, Verdict::pass);
    EXPECT_EQ(passes.scope->zones[0].excused_faces, 1u);
}

TEST(Zones, SearchDentsByTheLimitsOfEachFace) {
    ModelBuilder builder;
    test::flat_sheet(builder, {0, 80, 0});
    test::flat_sheet(builder, {0, 80, 0}, {500, 0, 0});
    const SurfaceModel model = builder.build();
    CriteriaPreset tight;
    tight.surface.waviness = {{0.01, 100}};
    const Inspection result = inspect(model, limits(model, {}, {zone("A", tight)}, {no_zone, 0}));
    const auto of_waves =
        std::count_if(result.checks.begin(), result.checks.end(),
                      [](const Check& c) { return c.code == "G-SU-WV" && c.face == 1; });
    EXPECT_EQ(of_waves, 1);
    EXPECT_EQ(std::count_if(result.checks.begin(), result.checks.end(),
                            [](const Check& c) { return c.code == "G-SU-WV"; }),
              1);
}

TEST(Zones, ReachProfiles) {
    const SurfaceModel model = strips({0.15, 0.15});
    const FaceLimits by_face = limits(model, {}, {zone("B", with_angle(0.2))}, {no_zone, 0, 0});
    const Inspection result = inspect(model, by_face);
    const std::vector<std::uint32_t> all{0, 1};
    const auto profiles = seam_profiles(model, result.seams, result.pieces, all, by_face);
    EXPECT_EQ(profiles[0].angle->limit, 0.1);
    EXPECT_EQ(profiles[1].angle->limit, 0.2);
}

TEST(Zones, OfAPresetNeedTheirFaces) {
    CriteriaPreset preset;
    preset.zones.push_back(zone("A", {}));
    EXPECT_THROW(FaceLimits{preset}, std::invalid_argument);
}

TEST(Zones, WithTwoFormulasPassNothingThatEitherFails) {
    test::Random random(7);
    const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
    const double flat_radius = 100000;
    const auto curvature = [&] {
        return std::pow(10.0, uniform(-6.5, -2)) * (uniform(0, 1) < 0.3 ? -1 : 1);
    };
    int passed = 0;
    for (int i = 0; i < 20000; ++i) {
        CriteriaPreset a, b;
        a.curvature = CurvatureLimit{CurvatureFormula::alias, uniform(0.01, 0.99)};
        b.curvature = CurvatureLimit{CurvatureFormula::catia, uniform(0.01, 1.99)};
        const CurvatureLimit both = *stricter_limits(a, b).curvature;
        EXPECT_EQ(both, *stricter_limits(b, a).curvature);
        const double k1 = curvature(), k2 = k1 * uniform(0.5, 1.5);
        const auto passes = [&](const CurvatureLimit& limit) {
            return curvature_mismatch(limit.formula, k1, k2, flat_radius) <= limit.limit;
        };
        if (!passes(both)) continue;
        ++passed;
        EXPECT_TRUE(passes(*a.curvature) && passes(*b.curvature)) << k1 << " " << k2;
    }
    EXPECT_GT(passed, 1000);
}

TEST(Scope, JudgesASeamOfWhichOneSideIsIn) {
    const Inspection result = in_scope(strips({0.3, 0, 0.3}), {false, false, false, true});
    EXPECT_EQ(result.verdict, Verdict::fail);
    ASSERT_EQ(result.seams.size(), 1u);
    EXPECT_EQ(result.seams[0].faces, "face 3 | face 4");
    EXPECT_EQ(result.seams[0].line, 0u);
    EXPECT_EQ(result.findings.size(), 1u);
    EXPECT_EQ(result.facts.seams, 1u);
    EXPECT_EQ(result.face_counts.pass, 1u) << "the faces out of scope have no verdict";
    ASSERT_TRUE(result.scope);
    EXPECT_EQ(result.scope->faces, 1u);
    EXPECT_EQ(result.scope->all_faces, 4u);
    EXPECT_EQ(result.scope->seams, 1u);
    EXPECT_EQ(result.scope->all_seams, 3u);
    EXPECT_EQ(result.scope->outside, (std::vector<std::string>{"face 1", "face 2", "face 3"}));
    EXPECT_FALSE(result.faces[0].in_scope);
    EXPECT_TRUE(result.faces[3].in_scope);
}

TEST(Scope, LetsFaultsBesideItPassAndCountsThem) {
    const SurfaceModel model = strips({0.3, 0, 0});
    EXPECT_EQ(inspect(model).verdict, Verdict::fail);
    const Inspection result = in_scope(model, {false, false, false, true});
    EXPECT_EQ(result.verdict, Verdict::pass);
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(result.scope->all_seams - result.scope->seams, 2u);
    EXPECT_TRUE(std::all_of(result.checks.begin(), result.checks.end(), [](const Check& check) {
        return check.seam != no_index || check.face == 3u;
    }));
}

TEST(Scope, HasFindingsAtBordersOfItsOwnFaces) {
    const SurfaceModel model = test::notched::notched_model({{55, 0}, {50, -5}, {45, 0}});
    const auto openings = [](const Inspection& inspection) {
        std::vector<std::uint32_t> faces;
        for (const Check& look : inspection.looks)
            if (look.code == "KEIKO-OPENING") faces.push_back(look.face);
        return faces;
    };
    ASSERT_EQ(openings(inspect(model)).size(), 1u);
    EXPECT_EQ(openings(in_scope(model, {true, false})), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(openings(in_scope(model, {false, true})), (std::vector<std::uint32_t>{1}));
}

/// A dent over a seam is the same with either of its faces in scope as with both: the other one is
/// searched too.
TEST(Scope, MeasuresDentsThatReachIntoIt) {
    const auto height = [](double x, double y) { return (x * x + y * y) / 4000; };
    const test::RoundDent dent{{2, 0}, 40, 0.06};
    const SurfaceModel model = test::dented_panel(height, dent, 0);
    const auto depths = [](const Inspection& inspection, std::uint32_t face) {
        std::vector<double> found;
        for (const Flaw& flaw : inspection.faces[face].flaws) found.push_back(flaw.depth.value);
        return found;
    };
    CriteriaPreset preset;
    preset.look.waviness = {{0.01, 100}};
    const Inspection whole = inspect(model, preset);
    const std::uint32_t dented = depths(whole, 0).empty() ? 1 : 0;
    ASSERT_FALSE(depths(whole, dented).empty());
    for (const bool first : {true, false}) {
        const Inspection part = in_scope(model, {first, !first}, preset);
        EXPECT_EQ(depths(part, dented), depths(whole, dented));
        const bool counts = first == (dented == 0);
        EXPECT_EQ(!part.looks.empty(), counts) << "of the face on which it is deepest";
    }
}

TEST(Scope, CountsAcceptedFindingsInItAlone) {
    const SurfaceModel model = strips({0.3, 0, 0.3});
    Inspection result = in_scope(model, {false, false, false, true});
    const Acceptance entry =
        acceptance_of(result.findings.at(0), result.seams, {"me", "by design", "2026-11-27", ""});
    accept_findings(result, {{entry}, "2026-11-28"});
    EXPECT_EQ(result.verdict, Verdict::pass);
    EXPECT_EQ(result.counts.accepted, 1u);
    EXPECT_EQ(result.face_counts.pass, 1u);
}

} // namespace
} // namespace keiko
