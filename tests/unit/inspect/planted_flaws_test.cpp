#include "keiko/files/scene/preset_file.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/inspection.h"

#include "tests/support/paths.h"
#include "tests/unit/inspect/flawed_sheets.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using test::bump, test::checks_of_flaws, test::everywhere, test::half_sheet, test::Polynomial,
    test::Profile, test::sheet, test::SheetForm, test::wave;

constexpr double limit = 0.01;
/// Convex, saddle, flat.
constexpr std::array<SheetForm, 3> forms{{{-1e-3, -2e-4}, {5e-4, -1e-3}, {0, 0}}};

/// Every dent and bump over the limit is found, none under it, where it is and as deep as it is.
TEST(PlantedFlaws, DentsAreFoundWhereTheyAreAndAsDeepAsTheyAre) {
    for (const SheetForm& form : forms)
        for (const double radius : {10.0, 25.0})
            for (const double depth : {0.001, 0.0098, 0.0102, 0.1, 1.0})
                for (const double side : {-1.0, 1.0}) {
                    SCOPED_TRACE(testing::Message()
                                 << form.bend_x << ' ' << radius << ' ' << side * depth);
                    const SurfaceModel model =
                        sheet(bump(21, radius), bump(-33, radius), side * depth, form);
                    const std::vector<Check> checks = checks_of_flaws(model, limit);
                    ASSERT_EQ(checks.size(), 1u);
                    const Check& check = checks[0];
                    EXPECT_EQ(check.is_finding(), depth > limit) << check.message;
                    if (depth < limit / 2) continue;
                    EXPECT_EQ(check.code, "KEIKO-DENT");
                    EXPECT_NEAR(check.worst.value, depth, 0.01 * depth);
                    EXPECT_EQ(check.worst.verdict, depth > limit ? Verdict::fail : Verdict::pass);
                    EXPECT_NEAR(check.worst.place.x, 21, 0.5);
                    EXPECT_NEAR(check.worst.place.y, -33, 0.5);
                    EXPECT_TRUE(check.message.starts_with(side < 0 ? "the dent" : "the bump"));
                }
}

/// An approximation hides no dent that is deeper than it is off.
TEST(PlantedFlaws, DentsAreFoundInFacesThatApproximateThoseOfTheFile) {
    SurfaceModel model = sheet(bump(21, 10), bump(-33, 10), -0.1, forms[0]);
    model.faces[0].approximated = 1e-4;
    const Check found = checks_of_flaws(model, limit).at(0);
    EXPECT_EQ(found.code, "KEIKO-DENT");
    EXPECT_NEAR(found.worst.value, 0.1, 0.001);
    EXPECT_GE(found.worst.bound, 1e-4);
    EXPECT_EQ(found.worst.verdict, Verdict::fail);
    model.faces[0].approximated = limit / 2;
    const Check hidden = checks_of_flaws(model, limit).at(0);
    EXPECT_EQ(hidden.worst.verdict, Verdict::undecided);
    EXPECT_NE(hidden.message.find("approximates one of the file too roughly"), std::string::npos)
        << hidden.message;
}

/// Coordinates are long beside the patches here.
TEST(PlantedFlaws, DentsAreFoundFarFromTheOrigin) {
    SurfaceModel model = sheet(bump(21, 10), bump(-33, 10), -0.1, forms[1]);
    model.instances[0].transform = Affine::translate({1e7, -7e6, 3e6});
    const std::vector<Check> checks = checks_of_flaws(model, limit);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].code, "KEIKO-DENT");
    EXPECT_NEAR(checks[0].worst.value, 0.1, 0.001);
    EXPECT_NEAR(checks[0].worst.place.x, 1e7 + 21, 0.5);
}

TEST(PlantedFlaws, WavesAreFoundAndAsDeepAsTheyAre) {
    for (const SheetForm& form : forms)
        for (const double length : {20.0, 37.5, 50.0})
            for (const double depth : {0.001, 0.0098, 0.0102, 0.1, 0.5}) {
                SCOPED_TRACE(testing::Message() << form.bend_x << ' ' << length << ' ' << depth);
                const SurfaceModel model = sheet(wave(length), everywhere(), depth, form);
                const std::vector<Check> checks = checks_of_flaws(model, limit);
                ASSERT_EQ(checks.size(), 1u);
                const Check& check = checks[0];
                EXPECT_EQ(check.is_finding(), depth > limit) << check.message;
                if (depth < limit / 2) continue;
                EXPECT_EQ(check.code, "G-SU-WV");
                EXPECT_NEAR(check.worst.value, depth, 0.01 * depth);
                const double crest = std::abs(std::remainder(check.worst.place.x, length / 2));
                EXPECT_NEAR(crest, length / 4, 0.5); // crests lie in the middles of the pieces
            }
}

/// Up to a tenth of their length, 33 degrees steep: as high as they stand on the form, and as long
/// as they are on it, not along the surface.
TEST(PlantedFlaws, SteepWavesAreAsDeepAsTheyStandOnTheForm) {
    for (const double bend : {0.0, -1e-3})
        for (const double length : {20.0, 50.0})
            for (const double share : {40.0, 20.0, 15.0, 10.0}) {
                SCOPED_TRACE(testing::Message() << bend << ' ' << length << ' ' << share);
                const double depth = length / share, half = 3 * length;
                const double window = std::max(51 * depth, 2.2 * length);
                const SurfaceModel model =
                    sheet(wave(length, half), everywhere(half), depth, {bend * 20 / half, 0});
                const std::vector<Check> checks = checks_of_flaws(model, 0.9 * depth, window);
                ASSERT_EQ(checks.size(), 1u);
                EXPECT_EQ(checks[0].code, "G-SU-WV");
                EXPECT_NEAR(checks[0].worst.value, depth, 0.002 * depth);
            }
}

/// The limits of class-a-waviness: waves from 20 to 200 mm, each reported once and as deep as it
/// is.
TEST(PlantedFlaws, SeveralWindowsTellEachWaveOnce) {
    CriteriaPreset preset;
    preset.surface = preset_by_name("class-a-waviness").surface;
    for (const double length : {20.0, 36.0, 50.0, 72.0, 100.0, 125.0, 160.0, 200.0})
        for (const double share : {0.9, 1.1, 3.0}) { // of the limit that is for such waves
            SCOPED_TRACE(testing::Message() << length << ' ' << share);
            const auto& limits = preset.surface.waviness;
            const auto measuring = std::find_if(limits.begin(), limits.end(), [&](const auto& l) {
                return length <= l.window / 2;
            });
            const double depth = share * measuring->depth, half = 3 * length;
            const Inspection found =
                inspect(sheet(wave(length, half), everywhere(half), depth, {-2e-4, 0}), preset);
            ASSERT_EQ(found.faces.size(), 1u);
            ASSERT_EQ(found.faces[0].flaws.size(), 1u);
            const Flaw& flaw = found.faces[0].flaws[0];
            EXPECT_EQ(flaw.kind, Flaw::Kind::waves);
            EXPECT_EQ(flaw.window, measuring->window);
            EXPECT_NEAR(flaw.depth.value, depth, 0.01 * depth);
            EXPECT_EQ(flaw.depth.verdict, share > 1 ? Verdict::fail : Verdict::pass);
        }
}

/// In a window for waves alone what bends but once is form, however wide.
TEST(PlantedFlaws, DentsAreFormToAWindowOfWavesAlone) {
    CriteriaPreset preset;
    preset.surface.waviness = {{0.01, 100}, {0.025, 250, true}};
    const auto flaws_of = [&](double radius) {
        const SurfaceModel model = sheet(bump(21, radius), bump(-33, radius), -0.1, {-2e-4, 0});
        return inspect(model, preset).faces.at(0).flaws;
    };
    EXPECT_EQ(flaws_of(20).size(), 1u);
    EXPECT_TRUE(flaws_of(60).empty());
    preset.surface.waviness[1].waves_only = false;
    ASSERT_EQ(flaws_of(20).size(), 1u) << "which both see";
    EXPECT_EQ(flaws_of(20)[0].window, 100);
    ASSERT_EQ(flaws_of(60).size(), 1u);
    EXPECT_NEAR(flaws_of(60)[0].depth.value, 0.1, 0.001);
    ASSERT_EQ(flaws_of(45).size(), 1u) << "as wide as the narrow one measures";
    EXPECT_EQ(flaws_of(45)[0].window, 100);
}

TEST(PlantedFlaws, NothingIsFoundOnTheCleanTwin) {
    for (const SheetForm& form : forms)
        for (const double least : {1e-5, limit}) {
            const std::vector<Check> checks =
                checks_of_flaws(sheet(bump(21, 25), bump(-33, 25), 0, form), least);
            ASSERT_EQ(checks.size(), 1u);
            EXPECT_EQ(checks[0].code, "G-SU-WV");
            EXPECT_EQ(checks[0].worst.value, 0);
            EXPECT_EQ(checks[0].worst.verdict, Verdict::pass);
        }
}

TEST(PlantedFlaws, TwoDentsFarApartAreTwoFindings) {
    Profile two = bump(-80, 20);
    two.knots = {-half_sheet, -100, -60, 60, 100, half_sheet};
    const Polynomial dent = two.pieces[1], nothing{};
    two.pieces = {nothing, dent, nothing, dent, nothing};
    const std::vector<Check> checks =
        checks_of_flaws(sheet(two, bump(0, 20), -0.05, {-1e-3, 0}), limit);
    ASSERT_EQ(checks.size(), 2u);
    for (const Check& check : checks) EXPECT_NEAR(check.worst.value, 0.05, 5e-4);
    EXPECT_NEAR(checks[0].worst.place.x + checks[1].worst.place.x, 0, 0.5);
}

TEST(PlantedFlaws, TheDentOfTheFixtureIsMeasured) {
    const SurfaceModel model = load_model(test::repository("surfaces/dent.step"));
    const std::vector<Check> checks = checks_of_flaws(model, limit, 200); // 120 mm wide
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::fail);
    EXPECT_NEAR(checks[0].worst.value, 0.1, 1e-3);
    EXPECT_NEAR(checks[0].worst.place.x, 40, 0.5);
    EXPECT_NEAR(checks[0].worst.place.y, -20, 0.5);
}

/// A window that is no wider than the dent cannot tell it from form.
TEST(PlantedFlaws, AreUndecidedWhereTheWindowIsTooNarrow) {
    const SurfaceModel model = load_model(test::repository("surfaces/dent.step"));
    const std::vector<Check> checks = checks_of_flaws(model, limit, 80);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::undecided);
    EXPECT_GT(checks[0].worst.value, limit);
    EXPECT_LT(checks[0].worst.value, 0.1);
    EXPECT_GT(checks[0].worst.bound, checks[0].worst.value / 4);
}

/// The bodies of the repository in which nobody planted anything.
TEST(PlantedFlaws, PresetPassesCleanFixtures) {
    const CriteriaPreset preset = preset_by_name("class-a-waviness");
    ASSERT_FALSE(preset.surface.waviness.empty());
    const auto faces_of = [&](const char* model) {
        return inspect(load_model(test::repository(std::string("surfaces/") + model)), preset)
            .faces;
    };
    for (const char* clean : {"hood.step", "pole.step", "rational-sphere.step", "seam-g2-only.step",
                              "concept-car.step"})
        for (const MeasuredFace& face : faces_of(clean))
            EXPECT_EQ(face.verdict, Verdict::pass) << clean << ", " << face.name;
    EXPECT_NE(faces_of("dent.step").at(0).verdict, Verdict::pass);
}

/// Its own width from the border a dent still has form all around it.
TEST(PlantedFlaws, DentsBesideBordersAreMeasuredWhereFormIsAround) {
    for (const double radius : {10.0, 15.0})
        for (const double margin : {2.0, 8.0}) {
            SCOPED_TRACE(testing::Message() << radius << ' ' << margin);
            const double centre = half_sheet - radius - margin;
            const std::vector<Check> checks = checks_of_flaws(
                sheet(bump(centre, radius), bump(7, radius), -0.05, {-1e-3, -2e-4}), limit);
            ASSERT_EQ(checks.size(), 1u);
            EXPECT_EQ(checks[0].code, "KEIKO-DENT");
            EXPECT_EQ(checks[0].worst.verdict, Verdict::fail);
            EXPECT_NEAR(checks[0].worst.value, 0.05, 0.01 * 0.05);
            EXPECT_NEAR(checks[0].worst.place.x, centre, 0.5);
        }
}

/// A bend of the form, 20 mm in radius between two planes, and one that changes its sense.
TEST(PlantedFlaws, BendsOfTheFormAreNone) {
    const double reach = 15, bend = 1.0 / 20; // z'' rises and falls again
    const double rise = bend * reach / 2;     // z' after each half
    Profile fold{{-half_sheet, -reach, 0, reach, half_sheet}, {}};
    const auto cubic = [&](double side) { // about the middle, at -+ reach / 2
        const double m = reach / 2, z2 = bend / 2, z3 = side * bend / reach;
        const double slope = side > 0 ? m * bend / 4 : rise + bend * m * 3 / 4;
        const double start = side > 0 ? bend * m * m * m / (6 * reach)
                                      : bend * reach * reach / 6 + rise * m + bend * m * m / 2 -
                                            bend * m * m * m / (6 * reach);
        return Polynomial{start, slope, z2 / 2, z3 / 6};
    };
    const double end = bend * reach * reach / 6 + rise * reach + bend * reach * reach / 3;
    fold.pieces = {{}, cubic(1), cubic(-1), {end + 2 * rise * (half_sheet - reach) / 2, 2 * rise}};
    const std::vector<Check> checks =
        checks_of_flaws(sheet(fold, everywhere(), 1, {0, -5e-4}), limit);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_EQ(checks[0].worst.verdict, Verdict::pass) << checks[0].message;
    EXPECT_EQ(checks[0].worst.value, 0);
}

} // namespace
} // namespace keiko
