#include "keiko/inspect/curvature/face_measure.h"

#include "keiko/inspect/inspection.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

SurfaceModel cylinder(double radius) {
    return test::cylinder_model(test::stretched({radius, radius, 20}, {0, 0, 1}, {500, 0, 0}));
}

CriteriaPreset at_least(double radius) {
    CriteriaPreset preset;
    preset.surface.minimum_radius = radius;
    return preset;
}

TEST(FaceMeasure, FailsWhereAFaceIsBentTighterThanTheLimit) {
    const Inspection tight = inspect(cylinder(0.4), at_least(0.5));
    ASSERT_EQ(tight.faces.size(), 1u);
    EXPECT_NEAR(tight.faces[0].radius->value, 0.4, 1e-9);
    EXPECT_EQ(tight.faces[0].verdict, Verdict::fail);
    EXPECT_EQ(tight.face_counts, (FaceCounts{1, 0, 0}));
    EXPECT_EQ(tight.verdict, Verdict::fail);
    ASSERT_EQ(tight.findings.size(), 1u);
    const Check& finding = tight.findings[0];
    EXPECT_EQ(finding.code, "G-SU-CR");
    EXPECT_EQ(finding.rule, "surface_with_small_curvature_radius");
    EXPECT_EQ(finding.faces, "face 1");
    EXPECT_EQ(finding.face, 0u);
    EXPECT_EQ(finding.seam, no_index);
    EXPECT_EQ(finding.message, "the smallest radius of 0.4 mm is under the limit of 0.5 mm");
    const Vec3& place = finding.worst.place;
    EXPECT_NEAR(std::hypot(place.x - 500, place.y), 0.4, 1e-9);
}

TEST(FaceMeasure, PassesWhereTheBoundTooIsWithinTheLimit) {
    const Inspection wide = inspect(cylinder(0.6), at_least(0.5));
    EXPECT_EQ(wide.faces[0].verdict, Verdict::pass);
    EXPECT_LT(wide.faces[0].radius->bound, 0.1);
    EXPECT_TRUE(wide.findings.empty());
}

TEST(FaceMeasure, CannotTellWhereTheLimitLiesWithinTheBound) {
    const MeasuredFace face = measure_faces(cylinder(0.6), {}).front();
    ASSERT_GT(face.radius->bound, 0);
    const double between = face.radius->value - face.radius->bound / 2;
    EXPECT_EQ(inspect(cylinder(0.6), at_least(between)).faces[0].verdict, Verdict::undecided);
}

TEST(FaceMeasure, ListsBendsNarrowerThanNegligibleWhereNoPresetJudgesThem) {
    const Inspection narrow = inspect(cylinder(0.05));
    EXPECT_EQ(narrow.verdict, Verdict::pass);
    ASSERT_EQ(narrow.looks.size(), 1u);
    EXPECT_EQ(narrow.looks[0].code, "G-SU-CR");
    EXPECT_EQ(narrow.looks[0].message,
              "the smallest radius of 0.05 mm is under the limit of 0.1 mm");
    EXPECT_TRUE(inspect(cylinder(0.11)).looks.empty());
    EXPECT_TRUE(inspect(cylinder(0.05), at_least(0.01)).looks.empty());
}

TEST(FaceMeasure, CountsWhatAnApproximationMayBeOff) {
    const auto verdict = [](double radius, double off) {
        SurfaceModel model = cylinder(radius);
        model.faces[0].approximated = off;
        return measure_faces(model, at_least(0.5)).front().verdict;
    };
    EXPECT_EQ(verdict(0.4, 1e-7), Verdict::fail);
    EXPECT_EQ(verdict(0.4, 0.01), Verdict::undecided);
    EXPECT_EQ(verdict(0.6, 1e-7), Verdict::pass);
    EXPECT_EQ(verdict(0.6, 0.01), Verdict::undecided);
}

TEST(FaceMeasure, JudgesNothingWithoutALimit) {
    const Inspection inspection = inspect(cylinder(0.4));
    EXPECT_NEAR(inspection.faces[0].radius->value, 0.4, 1e-9);
    EXPECT_EQ(inspection.faces[0].verdict, Verdict::pass);
    for (const Check& check : inspection.checks) EXPECT_EQ(check.face, no_index) << check.code;
}

TEST(FaceMeasure, KnowsNoRadiusOfAPlane) {
    test::ModelBuilder builder;
    builder.patch(1, 1, {{0, 0, 0}, {0, 50, 20}, {80, 0, 0}, {80, 50, 20}});
    const Inspection flat = inspect(builder.build(), at_least(0.5));
    EXPECT_FALSE(flat.faces[0].radius);
    ASSERT_EQ(flat.checks.size(), 1u);
    EXPECT_FALSE(flat.checks[0].judged);
    EXPECT_EQ(flat.checks[0].message, "the radius is not judged: the face is flat");
}

} // namespace
} // namespace keiko
