#include "keiko/scene/stricter_limits.h"

#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(StricterLimits, AreTheStricterOfEachCriterion) {
    CriteriaPreset a, b;
    a.gap = 0.01, b.gap = 0.02, a.angle = 0.3, b.angle = 0.2, a.fading = 0.1, b.fading = 0.2;
    a.curvature.reset(), b.curvature = CurvatureLimit{CurvatureFormula::alias, 0.2};
    a.curvature_slope = 1, b.curvature_slope = 2;
    a.lines = {0.5, std::nullopt, 3.0, std::nullopt}, b.lines = {0.4, 0.2, 4.0, std::nullopt};
    const CriteriaPreset both = stricter_limits(a, b);
    EXPECT_EQ(both.gap, 0.01);
    EXPECT_EQ(both.angle, 0.2);
    EXPECT_EQ(both.fading, 0.1);
    EXPECT_EQ(both.curvature, b.curvature) << "what one of them judges is judged";
    EXPECT_EQ(both.curvature_slope, 1);
    EXPECT_EQ(both.lines, (LineLimits{0.4, 0.2, 3.0, std::nullopt}));
}

TEST(LooserLimits, NameWhatAZoneLetsPass) {
    CriteriaPreset preset, zone;
    EXPECT_TRUE(looser_limits(zone, preset).empty());
    zone.gap = 0.001, zone.angle = 0.05;
    EXPECT_TRUE(looser_limits(zone, preset).empty()) << "stricter";
    zone.gap = 0.05, zone.curvature.reset(), zone.lines.turn = 0.5;
    preset.surface.minimum_radius = 5, zone.surface.minimum_radius = 2;
    preset.surface.waviness = {{0.01, 100}}, zone.surface.waviness = {{0.02, 100}};
    preset.structure.degree = 6;
    EXPECT_EQ(looser_limits(zone, preset),
              (std::vector<std::string>{
                  "gap 0.05 mm instead of 0.01 mm", "curvature mismatch not judged instead of 10 %",
                  "turn of lines 0.5 degrees instead of 0.1 degrees", "radius 2 mm instead of 5 mm",
                  "dents and waves in 100 mm 0.02 mm instead of 0.01 mm",
                  "degree not judged instead of 6"}));
}

TEST(LooserLimits, CompareDraftsAgainstOnePull) {
    CriteriaPreset preset, zone;
    preset.surface.draft = DraftLimit{3, {0, 0, 1}};
    EXPECT_EQ(looser_limits(zone, preset),
              (std::vector<std::string>{"draft not judged instead of 3 degrees"}));
    zone.surface.draft = DraftLimit{2, {0, 0, 1}};
    EXPECT_EQ(looser_limits(zone, preset),
              (std::vector<std::string>{"draft 2 degrees instead of 3 degrees"}));
    zone.surface.draft = DraftLimit{4, {0, 0, -1}};
    EXPECT_EQ(
        looser_limits(zone, preset),
        (std::vector<std::string>{"draft against another pull 4 degrees instead of 3 degrees"}));
    zone.surface.draft->pull = {0, 0, 1};
    EXPECT_TRUE(looser_limits(zone, preset).empty());
}

TEST(LooserLimits, CompareFormulasByWhatTheyPass) {
    CriteriaPreset preset, zone; // alias 10 % is catia 18.2 %
    zone.curvature = CurvatureLimit{CurvatureFormula::catia, 0.18};
    EXPECT_TRUE(looser_limits(zone, preset).empty());
    zone.curvature->limit = 0.19;
    EXPECT_EQ(
        looser_limits(zone, preset),
        (std::vector<std::string>{"curvature mismatch by another formula 19 % instead of 10 %"}));
}

} // namespace
} // namespace keiko
