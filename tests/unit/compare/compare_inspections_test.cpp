#include "keiko/compare/compare_inspections.h"

#include "keiko/base/units.h"

#include "tests/support/model_builder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

using test::ModelBuilder;

/// Sheets beside each other along y, each tilted by so many degrees against the one before.
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
    EXPECT_NEAR(difference.changed[0].angle, 0.3, 1e-9);
    EXPECT_NEAR(difference.changed[0].gap, 0, 1e-12);
    EXPECT_EQ(difference.changed[0].verdict_before, Verdict::pass);
    EXPECT_EQ(difference.changed[0].verdict_after, Verdict::fail);
    ASSERT_EQ(difference.new_findings.size(), 1u);
    EXPECT_EQ(difference.new_findings[0].code, "G-SU-NT");
    EXPECT_TRUE(difference.solved_findings.empty());
}

TEST(CompareInspections, CreditsASeamThatWasRepaired) {
    const auto difference = compare_inspections(strips({0}, 0.04), strips({0}, 0));
    ASSERT_EQ(difference.changed.size(), 1u);
    EXPECT_NEAR(difference.changed[0].gap, -0.04, 1e-12);
    ASSERT_EQ(difference.solved_findings.size(), 1u);
    EXPECT_EQ(difference.solved_findings[0].code, "G-SU-LG");
    EXPECT_TRUE(difference.new_findings.empty());
}

TEST(CompareInspections, DoesNotCallAKnownFindingNew) {
    const auto difference = compare_inspections(strips({0.2}), strips({0.3}));
    EXPECT_EQ(difference.changed.size(), 1u);
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

TEST(CompareInspections, PrefersTheFacesNameToANearerStranger) {
    Inspection before, after;
    MeasuredSeam seam;
    seam.faces = "face 1 | face 2", seam.middle = Vec3(0, 0, 0);
    before.seams = {seam};
    MeasuredSeam stranger = seam, renamed = seam;
    stranger.faces = "face 8 | face 9", stranger.middle = Vec3(1, 0, 0);
    renamed.middle = Vec3(5, 0, 0);
    after.seams = {stranger, renamed};
    EXPECT_EQ(compare_inspections(before, after).added, std::vector<std::uint32_t>{0});
    after.seams[1].middle = Vec3(50, 0, 0); // too far to be the same seam
    EXPECT_EQ(compare_inspections(before, after).added, std::vector<std::uint32_t>{1});
}

} // namespace
} // namespace keiko
