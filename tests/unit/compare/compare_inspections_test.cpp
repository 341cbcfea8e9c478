#include "keiko/compare/compare_inspections.h"

#include "keiko/base/units.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::ModelBuilder;

/// Sheets beside each other along y, each tilted by its number of `degrees` against the one before.
Inspection strips(const std::vector<double>& degrees, double gap = 0) {
    ModelBuilder builder;
    Vec3 from(0);
    double tilt = 0;
    for (std::size_t i = 0; i <= degrees.size(); ++i) {
        const Vec3 across(0, 50 * std::cos(tilt), -50 * std::sin(tilt));
        builder.plane(from, {100, 0, 0}, across);
        from += across + Vec3(0, gap, 0);
        if (i < degrees.size()) tilt += degrees_to_radians(degrees[i]);
    }
    return inspect(builder.build());
}

TEST(CompareInspections, FindsNoDifferenceOfAPartToItself) {
    const Inspection part = strips({0.2, 0, 30}, 0.02);
    const InspectionDifference difference = compare_inspections(part, part);
    EXPECT_TRUE(difference.empty());
    EXPECT_EQ(difference.matched, 3u);
}

TEST(CompareInspections, MeasuresHowASeamGotWorse) {
    const auto difference = compare_inspections(strips({0.02, 0.05}), strips({0.02, 0.35}));
    ASSERT_EQ(difference.changed.size(), 1u);
    EXPECT_NEAR(difference.changed[0].angle(), 0.3, 1e-9);
    EXPECT_NEAR(difference.changed[0].gap(), 0, 1e-12);
    EXPECT_EQ(difference.changed[0].before.verdict, Verdict::pass);
    EXPECT_EQ(difference.changed[0].after.verdict, Verdict::fail);
    EXPECT_EQ(difference.changed[0].trend, SeamTrend::worse);
    ASSERT_EQ(difference.new_findings.size(), 1u);
    EXPECT_EQ(difference.new_findings[0].code, "G-SU-NT");
    EXPECT_TRUE(difference.solved_findings.empty());
}

TEST(CompareInspections, CreditsASeamThatWasRepaired) {
    const auto difference = compare_inspections(strips({0}, 0.04), strips({0}, 0));
    ASSERT_EQ(difference.changed.size(), 1u);
    EXPECT_NEAR(difference.changed[0].gap(), -0.04, 1e-12);
    EXPECT_EQ(difference.changed[0].trend, SeamTrend::better);
    ASSERT_EQ(difference.solved_findings.size(), 1u);
    EXPECT_EQ(difference.solved_findings[0].code, "G-SU-LG");
    EXPECT_TRUE(difference.new_findings.empty());
}

TEST(CompareInspections, DoesNotCallAKnownFindingNew) {
    const auto difference = compare_inspections(strips({0.2}), strips({0.3}));
    EXPECT_EQ(difference.changed.size(), 1u);
    EXPECT_EQ(difference.same_findings.size(), 1u);
    EXPECT_TRUE(difference.new_findings.empty());
    EXPECT_TRUE(difference.solved_findings.empty());
}

TEST(CompareInspections, ListsSeamsWithoutAPartner) {
    const auto grown = compare_inspections(strips({0.2}), strips({0.2, 0.4}));
    EXPECT_EQ(grown.added, std::vector<std::uint32_t>{1});
    EXPECT_TRUE(grown.removed.empty());
    ASSERT_EQ(grown.new_findings.size(), 1u);
    EXPECT_NEAR(grown.new_findings[0].worst.value, 0.4, 1e-9);
    const auto shrunk = compare_inspections(strips({0.2, 0.4}), strips({0.2}));
    EXPECT_EQ(shrunk.removed, std::vector<std::uint32_t>{1});
    EXPECT_EQ(shrunk.solved_findings.size(), 1u);
}

/// A seam of these faces along x at height y.
MeasuredSeam straight(const std::string& faces, double y, double from = 0, double to = 100) {
    MeasuredSeam seam;
    seam.faces = faces, seam.length = to - from;
    seam.course.emplace_back();
    for (int i = 0; i <= 32; ++i)
        seam.course.back().emplace_back(from + (to - from) * i / 32, y, 0);
    return seam;
}

Inspection with(std::vector<MeasuredSeam> seams) {
    Inspection inspection;
    inspection.seams = std::move(seams);
    return inspection;
}

TEST(CompareInspections, PrefersTheFacesNameToANearerStranger) {
    const Inspection before = with({straight("face 1 | face 2", 0)});
    Inspection after = with({straight("face 8 | face 9", 1), straight("face 1 | face 2", 5)});
    EXPECT_EQ(compare_inspections(before, after).added, std::vector<std::uint32_t>{0});
    after.seams[1] = straight("face 1 | face 2", 50); // too far to be the same seam
    EXPECT_EQ(compare_inspections(before, after).added, std::vector<std::uint32_t>{1});
}

TEST(CompareInspections, PairsByPlaceWhereFacesAreNumberedAnew) {
    const Inspection before =
        with({straight("face 1 | face 2", 0), straight("face 2 | face 3", 4)});
    const Inspection after = with({straight("face 2 | face 3", 0), straight("face 1 | face 2", 4)});
    const InspectionDifference difference = compare_inspections(before, after);
    EXPECT_TRUE(difference.empty());
    EXPECT_EQ(difference.matched, 2u);
}

TEST(CompareInspections, TakesASeamThatWasDividedForTheSame) {
    const Inspection before = with({straight("face 1 | face 2", 0)});
    const Inspection after =
        with({straight("face 1 | face 2", 0, 0, 60), straight("face 1 | face 3", 0, 60, 100)});
    EXPECT_TRUE(compare_inspections(before, after).empty());
    EXPECT_TRUE(compare_inspections(after, before).empty());
    EXPECT_EQ(match_seams(before.seams, after.seams, 10).groups[0].after,
              (std::vector<std::uint32_t>{0, 1}));
}

/// Fails its gap, or else passes that and fails its curvature.
MeasuredSeam failing(MeasuredSeam seam, double gap, double mismatch) {
    seam.gap = {gap, 0, 0.01, Vec3(0), judge(gap, 0, 0.01)};
    seam.verdict = seam.gap.verdict, seam.severity = gap / 0.01;
    if (seam.verdict != Verdict::pass) return seam;
    seam.curvature.emplace();
    seam.curvature->mismatch = mismatch;
    seam.curvature->worst = {mismatch, 0, 0.1, Vec3(0), Verdict::fail};
    seam.verdict = Verdict::fail, seam.severity = mismatch / 0.1;
    return seam;
}

TEST(CompareInspections, DoesNotJudgePiecesOfADividedSeamFurtherThanTheWhole) {
    const Inspection before = with({failing(straight("face 1 | face 2", 0), 0.02, 0)});
    Inspection after = with({failing(straight("face 1 | face 2", 0, 0, 60), 0.02, 0),
                             failing(straight("face 1 | face 2", 0, 60, 100), 0.001, 1)});
    after.findings.resize(1);
    after.findings[0].code = "G-SU-NS", after.findings[0].seam = 1;
    const InspectionDifference difference = compare_inspections(before, after);
    EXPECT_TRUE(difference.changed.empty());
    EXPECT_TRUE(difference.new_findings.empty());
    after.seams[0] = failing(straight("face 1 | face 2", 0, 0, 60), 0.001, 0.2);
    EXPECT_EQ(compare_inspections(before, after).new_findings.size(), 1u);
}

TEST(CompareInspections, RanksChangesByGapAndAngleBeforeCurvature) {
    const auto seams = [](double gap, double mismatch) {
        return with({failing(straight("face 1 | face 2", 0), 0, mismatch),
                     failing(straight("face 3 | face 4", 500), gap, 0)});
    };
    const InspectionDifference difference =
        compare_inspections(seams(0.012, 0.2), seams(0.02, 1.0));
    ASSERT_EQ(difference.changed.size(), 2u);
    EXPECT_EQ(difference.changed[0].seams.before[0], 1u);
}

TEST(CompareInspections, DoesNotPairSeamsThatOnlyCross) {
    MeasuredSeam across = straight("face 1 | face 2", 0);
    for (Vec3& p : across.course[0]) p = Vec3(50, p.x - 50, 0);
    const InspectionDifference difference =
        compare_inspections(with({straight("face 1 | face 2", 0)}), with({across}));
    EXPECT_EQ(difference.removed.size(), 1u);
    EXPECT_EQ(difference.added.size(), 1u);
}

} // namespace
} // namespace keiko
