#include "keiko/inspect/regularity/face_draft.h"

#include "keiko/inspect/inspection.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <random>

namespace keiko {
namespace {

using std::numbers::pi;

/// A cone about z that narrows upwards; its wall is `angle` degrees from the vertical.
SurfaceModel cone(double angle) {
    test::ModelBuilder builder;
    const double top = 100 - 40 * std::tan(angle * pi / 180);
    builder.nurbs(test::revolution(1, {0, 0, 1, 1}, {{100, 0, 0, 1}, {top, 0, 40, 1}}));
    return builder.build();
}

/// The part of a sphere of 100 mm about the origin that lies above an elevation, degrees.
SurfaceModel cap(double elevation, const Affine& placed = {}, bool reversed = false) {
    const double a = elevation * pi / 180, half = (pi / 2 - a) / 2, middle = a + half;
    const double w = std::cos(half), r = 100 / w; // of the middle control point
    test::ModelBuilder builder;
    builder.nurbs(test::revolution(2, {0, 0, 0, 1, 1, 1},
                                   {{100 * std::cos(a), 0, 100 * std::sin(a), 1},
                                    {w * r * std::cos(middle), 0, w * r * std::sin(middle), w},
                                    {0, 0, 100, 1}}));
    builder.instance(placed);
    SurfaceModel model = builder.build();
    model.faces[0].reversed = reversed;
    return model;
}

MeasuredValue draft_of(const SurfaceModel& model, double limit = 3, const Vec3& pull = {0, 0, 1}) {
    return smallest_draft(model, 0, 0, {limit, pull}).value();
}

TEST(FaceDraft, OfAConeIsItsHalfAngle) {
    for (const double angle : {0.5, 3.0, 30.0, -7.0}) {
        const MeasuredValue found = draft_of(cone(angle), 3);
        EXPECT_NEAR(found.value, angle, 1e-9);
        EXPECT_LE(found.bound, draft_tolerance / 2);
        EXPECT_EQ(found.verdict, angle < 3 ? Verdict::fail : Verdict::pass) << angle;
        EXPECT_TRUE(found.at_least);
        const double radius = 100 - found.place.z * std::tan(angle * pi / 180);
        EXPECT_NEAR(std::hypot(found.place.x, found.place.y), radius, 1e-9);
    }
    EXPECT_EQ(draft_of(cone(3), 3.01).verdict, Verdict::fail);
    EXPECT_EQ(draft_of(cone(3), 2.99).verdict, Verdict::pass);
}

TEST(FaceDraft, OfWallsAlongThePullIsZero) {
    const SurfaceModel tube = test::cylinder_model(test::stretched(Vec3(50), {1, 2, 3}, Vec3(7)));
    const MeasuredValue along = draft_of(tube, 0, {2, 4, 6});
    EXPECT_NEAR(along.value, 0, 1e-9);
    EXPECT_EQ(along.verdict, Verdict::pass);
    EXPECT_EQ(draft_of(tube, 1, {1, 2, 3}).verdict, Verdict::fail);
    EXPECT_NEAR(draft_of(tube, 0, {3, 0, -1}).value, -90, 1e-3); // its underside
}

TEST(FaceDraft, OfASphereIsTheElevationOfItsLowestPlace) {
    for (const double elevation : {60.0, 30.0, 0.0, -20.0}) {
        const MeasuredValue found = draft_of(cap(elevation));
        EXPECT_NEAR(found.value, elevation, 1e-4);
        EXPECT_LE(found.bound, draft_tolerance / 2);
        EXPECT_NEAR(found.place.z, 100 * std::sin(elevation * pi / 180), 1e-3);
    }
}

/// The trim leaves what lies above 45 degrees of a hemisphere.
TEST(FaceDraft, IsOfWhatTrimsLeave) {
    const double s = std::numbers::sqrt2 / 2;
    test::ModelBuilder builder;
    builder.nurbs(test::revolution(2, {0, 0, 0, 1, 1, 1},
                                   {{100, 0, 0, 1}, {100 * s, 0, 100 * s, s}, {0, 0, 100, 1}}));
    builder.polygon({{0, 0.5}, {4, 0.5}, {4, 1}, {0, 1}});
    const MeasuredValue found = draft_of(builder.build(), 40);
    EXPECT_NEAR(found.value, 45, 0.01);
    EXPECT_LT(found.bound, 0.1);
    EXPECT_GE(45, found.value - found.bound - 1e-6);
    EXPECT_EQ(found.verdict, Verdict::pass);
}

TEST(FaceDraft, FollowsTheOutsideThroughPlacements) {
    EXPECT_NEAR(draft_of(cap(30, {}, true)).value, -90, 1e-3);
    const Affine beside = test::stretched({-1, 1, 1}, {0, 0, 1}, Vec3(500, 0, 0));
    ASSERT_TRUE(beside.mirrored());
    EXPECT_NEAR(draft_of(cap(30, beside)).value, 30, 1e-4);
    EXPECT_NEAR(draft_of(cap(30, beside, true)).value, -90, 1e-3);
    const Affine below = test::stretched({1, 1, -1}, {0, 0, 1}, Vec3(0));
    EXPECT_NEAR(draft_of(cap(30, below)).value, -90, 1e-3);
    EXPECT_NEAR(draft_of(cap(30, below), 3, {0, 0, -1}).value, 30, 1e-4);
    const Affine turned = test::stretched({1, 1, 1}, {1, 0, 1}, Vec3(0));
    EXPECT_NEAR(draft_of(cap(30, turned), 3, {1, 0, 1}).value, 30, 1e-4);
}

/// The bound holds what dense sampling finds, and the value is a place of the face.
TEST(FaceDraft, BoundsEverySampleOfWavyPatches) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> wave(-60, 60);
    for (int run = 0; run < 20; ++run) {
        test::ModelBuilder builder;
        std::vector<Vec3> points;
        for (int i = 0; i <= 3; ++i)
            for (int j = 0; j <= 3; ++j) points.emplace_back(100 * i, 100 * j, wave(random));
        builder.patch(3, 3, points);
        const SurfaceModel model = builder.build();
        const MeasuredValue found = draft_of(model);
        double least = 90;
        for (int i = 0; i <= 100; ++i)
            for (int j = 0; j <= 100; ++j) {
                const SurfaceDerivatives s = evaluate(model.patch(0), {i / 100.0, j / 100.0}, 1);
                least = std::min(least, draft_angle(s.du().cross(s.dv()), {0, 0, 1}));
            }
        EXPECT_GE(least, found.value - found.bound - 1e-9) << run;
        EXPECT_LE(found.value, least + draft_tolerance) << run;
        EXPECT_LE(found.bound, draft_tolerance / 2) << run;
    }
}

TEST(FaceDraft, IsACheckOfItsOwn) {
    CriteriaPreset preset;
    EXPECT_FALSE(inspect(cone(2)).faces[0].draft);
    preset.surface.draft = DraftLimit{3};
    const Inspection steep = inspect(cone(2), preset);
    ASSERT_EQ(steep.findings.size(), 1u);
    EXPECT_EQ(steep.findings[0].code, "KEIKO-DRAFT");
    EXPECT_EQ(steep.findings[0].message,
              "the smallest draft of 2 degrees is under the limit of 3 degrees");
    EXPECT_EQ(steep.faces[0].verdict, Verdict::fail);
    const Inspection undercut = inspect(cone(-2), preset);
    EXPECT_EQ(undercut.findings.at(0).message,
              "the smallest draft of -2 degrees is under the limit of 3 degrees; the face is "
              "undercut there");
    EXPECT_EQ(inspect(cone(4), preset).verdict, Verdict::pass);
}

} // namespace
} // namespace keiko
