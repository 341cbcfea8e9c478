#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/fading_defects.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

using test::FadingDefect, test::add_sheet;

Inspection inspected(const FadingDefect& defect, const CriteriaPreset& preset,
                     double bend = 1 / test::defect_radius) {
    test::ModelBuilder builder;
    add_sheet(builder, -test::defect_length, bend, {});
    add_sheet(builder, 0, bend, defect);
    return inspect(builder.build(), preset);
}

/// One fault of a kind, and the quantity and size that have to be measured.
struct Planted {
    const char* quantity;
    double size; ///< in the unit of the check
    FadingDefect defect;
};

std::vector<Planted> planted(const CriteriaPreset& preset) {
    std::vector<Planted> all;
    for (const double gap : {0.0005, 0.005, 0.0098, 0.0102, 0.02, 0.05, 0.1})
        all.push_back({"gap", gap, {.gap = gap}});
    for (const double angle : {0.005, 0.02, 0.098, 0.102, 0.2, 0.5, 1.0})
        all.push_back({"angle", angle, {.slope = std::tan(degrees_to_radians(angle))}});
    for (const double m : {0.005, 0.02, 0.098, 0.102, 0.2, 0.5}) {
        if (!preset.curvature) break;
        const bool alias = preset.curvature->formula == CurvatureFormula::alias;
        const double other = alias ? (1 + m) / (1 - m) : 1 / (1 - m);
        all.push_back({"curvature", m, {.curvature = (other - 1) / test::defect_radius}});
    }
    for (const double angle : {0.02, 0.098, 0.102, 1.0, 20.0})
        if (preset.curvature_slope)
            all.push_back({"curvature_slope",
                           angle,
                           {.change = std::tan(degrees_to_radians(angle)) / test::defect_radius /
                                      test::defect_radius}});
    return all;
}

/// On the limit itself its error bound straddles it.
Verdict verdict_of(double size, double limit) {
    if (std::abs(size - limit) < 1e-9 * limit) return Verdict::undecided;
    return size > limit ? Verdict::fail : Verdict::pass;
}

/// Every fault above its limit is found, none below it, where it is and as large as it is.
TEST(PlantedDefects, AreFoundWhereTheyAreAndAsLargeAsTheyAre) {
    for (const CriteriaPreset& preset : standard_presets())
        for (const Planted& fault : planted(preset)) {
            SCOPED_TRACE(preset.name + ": " + fault.quantity + " " + std::to_string(fault.size));
            const Inspection found = inspected(fault.defect, preset);
            ASSERT_EQ(found.seams.size(), 1u);
            const auto check =
                std::find_if(found.checks.begin(), found.checks.end(),
                             [&](const Check& c) { return c.quantity == fault.quantity; });
            ASSERT_NE(check, found.checks.end());
            ASSERT_TRUE(check->judged) << check->message;
            EXPECT_NEAR(check->worst.value, fault.size, 1e-6 * fault.size + 1e-9);
            EXPECT_LE(std::abs(check->worst.value - fault.size), check->worst.bound + 1e-9);
            EXPECT_NEAR(check->worst.place.x, 0, 1e-6);
            EXPECT_NEAR(check->worst.place.y, test::defect_place, 0.1);
            const Verdict expected = verdict_of(fault.size, check->worst.limit);
            EXPECT_EQ(check->worst.verdict, expected);
            // A gap that fades away along the seam tilts the border: that may be one more.
            const bool tilts = fault.defect.gap > 0 && found.findings.size() == 2;
            EXPECT_EQ(found.findings.size() - tilts, expected == Verdict::pass ? 0u : 1u);
            if (expected != Verdict::pass) {
                EXPECT_EQ(found.verdict, expected);
            }
        }
}

TEST(PlantedDefects, NothingIsFoundOnTheCleanTwin) {
    for (const CriteriaPreset& preset : standard_presets())
        for (const double bend :
             {1 / test::defect_radius, -1 / test::defect_radius, 0.01, 1e-6, 0.0}) {
            const Inspection found = inspected({}, preset, bend);
            ASSERT_EQ(found.seams.size(), 1u);
            EXPECT_EQ(found.verdict, Verdict::pass) << preset.name << ' ' << bend;
            EXPECT_TRUE(found.findings.empty());
        }
}

TEST(PlantedDefects, AreNotSeenInCreasesAndNearlyFlatSeams) {
    for (const CriteriaPreset& preset : standard_presets()) {
        // It is down to six tenths of that at the seam's end.
        const double sharp = std::tan(degrees_to_radians(2 * preset.feature_angle));
        const Inspection crease = inspected({.slope = sharp}, preset);
        EXPECT_EQ(crease.counts.creases, 1u);
        EXPECT_TRUE(crease.findings.empty()) << preset.name;
        if (!preset.curvature) continue;
        // A mismatch of 100 % of the sheets' own curvatures, which no light shows.
        const double base = preset.curvature->formula == CurvatureFormula::alias ? 2 : 1;
        const double allowed = preset.curvature->limit * base / preset.flat_radius;
        const Inspection flat = inspected({.curvature = 0.98 * allowed}, preset, 0);
        EXPECT_TRUE(flat.findings.empty()) << preset.name;
        EXPECT_EQ(inspected({.curvature = 1.02 * allowed}, preset, 0).findings.size(), 1u);
        const Inspection bent = inspected({.curvature = 1e-4}, preset, 0);
        EXPECT_EQ(bent.findings.size(), 1u) << preset.name;
    }
}

} // namespace
} // namespace keiko
