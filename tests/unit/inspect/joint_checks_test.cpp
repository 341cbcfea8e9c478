// Joints held against the limits of a preset.
#include "keiko/inspect/joint_checks.h"

#include "keiko/inspect/inspection.h"

#include "tests/unit/inspect/joint_panels.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

using namespace test::joints;

CriteriaPreset preset_of(const JointLimits& limits) {
    CriteriaPreset preset;
    preset.joint = limits;
    return preset;
}

Inspection checked(const std::vector<Panel>& panels, const JointLimits& limits) {
    const SurfaceModel model = model_of(panels);
    Inspection inspection = inspect(model, preset_of(limits), join);
    check_joints(model, inspection);
    return inspection;
}

/// The check of a code; there is one.
Check only_check(const Inspection& inspection, std::string_view code) {
    std::vector<Check> found;
    std::copy_if(inspection.checks.begin(), inspection.checks.end(), std::back_inserter(found),
                 [&](const Check& check) { return check.code == code; });
    EXPECT_EQ(found.size(), 1u) << code;
    return found.at(0);
}

constexpr double exact = 1e-6; // mm

TEST(JointChecks, HoldGapAndFlushAgainstTheirNominalSizes) {
    JointLimits limits;
    limits.gap = NominalSize{3.5, 0.6}, limits.flush = NominalSize{0, 0.3};
    const Inspection inspection = checked(pair_of(4, -0.4), limits);
    const Check gap = only_check(inspection, "KEIKO-JOINT-GAP");
    EXPECT_NEAR(gap.worst.value, 0.5, exact);
    EXPECT_EQ(gap.worst.verdict, Verdict::pass);
    const Check flush = only_check(inspection, "KEIKO-JOINT-FLUSH");
    EXPECT_NEAR(flush.worst.value, 0.4, exact);
    EXPECT_EQ(flush.worst.verdict, Verdict::fail);
    EXPECT_EQ(flush.faces, "face 1 | face 4");
    EXPECT_EQ(flush.face, 0u);
    EXPECT_EQ(flush.message,
              "the deviation of the flush from 0 mm of 0.4 mm is over the limit of 0.3 mm; the "
              "second panel stands out by -0.4 to -0.4 mm");
    EXPECT_EQ(inspection.verdict, Verdict::fail);
    EXPECT_EQ(std::count_if(inspection.findings.begin(), inspection.findings.end(),
                            [](const Check& c) { return c.code.starts_with("KEIKO-JOINT"); }),
              1);
}

TEST(JointChecks, TakeTheSmallestGapWhereThatDeviatesMore) {
    JointLimits limits;
    limits.gap = NominalSize{4.5, 0.3};
    const Check gap = only_check(checked(pair_of(4, 0), limits), "KEIKO-JOINT-GAP");
    EXPECT_NEAR(gap.worst.value, 0.5, exact);
    EXPECT_EQ(gap.worst.verdict, Verdict::fail);
}

TEST(JointChecks, OfParallelismTakeTheDifferenceOfTheGaps) {
    std::vector<Panel> panels = pair_of(4, 0);
    panels[1].along = Vec3(1, 0.005, 0).normalized();
    panels[1].forward = Vec3(0.005, -1, 0).normalized();
    for (const double limit : {0.9, 1.1}) {
        JointLimits limits;
        limits.parallelism = limit;
        const Inspection inspection = checked(panels, limits);
        const Check check = only_check(inspection, "KEIKO-JOINT-PARALLEL");
        const JointExtremes& extremes = *inspection.joints->at(0).extremes;
        EXPECT_EQ(check.worst.value, extremes.widest.gap - extremes.narrowest.gap);
        EXPECT_NEAR(check.worst.value, 1, 0.05);
        EXPECT_EQ(check.worst.verdict, limit < 1 ? Verdict::fail : Verdict::pass);
        EXPECT_NEAR(check.worst.place.x, 200, 0.1);
    }
}

TEST(JointChecks, OfRadiiTakeTheSharperEdge) {
    for (const double least : {1.9, 2.1}) {
        JointLimits limits;
        limits.radius = least;
        const Check check = only_check(checked(pair_of(4, 0), limits), "KEIKO-JOINT-RADIUS");
        EXPECT_NEAR(check.worst.value, 2, exact);
        EXPECT_EQ(check.worst.verdict, least > 2 ? Verdict::fail : Verdict::pass);
        EXPECT_TRUE(check.worst.at_least);
    }
}

TEST(JointChecks, AreNoneWithoutLimitsButJointsAreListed) {
    const Inspection inspection = checked(pair_of(4, 0), {});
    EXPECT_EQ(inspection.joints->size(), 1u);
    EXPECT_TRUE(std::none_of(inspection.checks.begin(), inspection.checks.end(),
                             [](const Check& c) { return c.code.starts_with("KEIKO-JOINT"); }));
}

TEST(JointChecks, AreUndecidedWhereSectionsAreLost) {
    JointLimits limits;
    limits.gap = NominalSize{4, 0.5}, limits.radius = 1;
    Joint joint = joints_of(model_of(pair_of(4, 0)), limits).at(0);
    joint.unmeasured = 20, joint.unmeasured_place = {7, 8, 9};
    for (const Check& check : checks_of(joint, limits)) {
        EXPECT_EQ(check.worst.verdict, Verdict::undecided);
        EXPECT_NE(check.message.find("; 20 mm of the joint, from (7, 8, 9) on, cannot be measured"),
                  std::string::npos);
    }
    joint.extremes.reset();
    const std::vector<Check> unknown = checks_of(joint, limits);
    ASSERT_EQ(unknown.size(), 2u);
    EXPECT_EQ(unknown[0].worst.verdict, Verdict::undecided);
    EXPECT_EQ(unknown[0].worst.limit, 0.5);
}

TEST(JointChecks, DoNothingWhereTheyAreNotRequested) {
    EXPECT_FALSE(inspect(model_of(pair_of(4, 0))).joints);
}

} // namespace
} // namespace keiko
