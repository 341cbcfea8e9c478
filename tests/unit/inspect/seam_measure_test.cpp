#include "keiko/inspect/seams/seam_measure.h"

#include "keiko/base/units.h"
#include "keiko/files/scene/preset_file.h"

#include "tests/unit/inspect/measured_seams.h"
#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;
using test::arc_sheet;
using test::down;
using test::flat_sheet;
using test::hump;
using test::join;
using test::measured;
using test::ModelBuilder;
using test::only_seam;
using test::peak;
using test::sheet_length;

TEST(MeasureSeams, GivesTheGapBetweenTwoPlanes) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0}, {0, 0.03, 0.04});
    flat_sheet(builder, {0, -50, 0});
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.gap.value, 0.05, 1e-13);
    EXPECT_LT(seam.gap.bound, 1e-9);
    EXPECT_EQ(seam.gap.verdict, Verdict::fail);
    EXPECT_NEAR(seam.angle->value, 0, 1e-9);
    EXPECT_NEAR(seam.length, sheet_length, 1e-10);
    EXPECT_NEAR(seam.severity, 5, 1e-9);
}

TEST(MeasureSeams, GivesTheAngleBetweenTwoPlanes) {
    for (const double degrees : {0.001, 0.05, 0.2, -3.0, 30.0, 90.0, 135.0, 179.9}) {
        ModelBuilder builder;
        flat_sheet(builder, {0, 50, 0});
        flat_sheet(builder, down(degrees));
        EXPECT_NEAR(measured(builder.build()).at(0).angle->value, std::abs(degrees), 1e-9);
    }
}

TEST(MeasureSeams, TellsSheetsThatLieOnEachOtherFromASmoothContinuation) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    flat_sheet(builder, {0, 40, 0}); // back over the first one
    const auto seams = measured(builder.build());
    ASSERT_EQ(seams.size(), 3u); // the fold, and its two ends where the sheets lie on each other
    EXPECT_NEAR(seams[0].length, sheet_length, 1e-10);
    EXPECT_NEAR(seams[0].angle->value, 180, 1e-9);
    EXPECT_EQ(seams[0].kind, SeamClass::fold); // doubled material, no edge
    EXPECT_EQ(seams[0].verdict, Verdict::fail);
}

TEST(MeasureSeams, TellsSkinsOverEachOtherFromOtherFolds) {
    struct Sheet {
        Vec3 across, shift;
        bool stacked;
    };
    // Apart along the normals, in the plane beside and over the first one, and by next to nothing.
    for (const Sheet& other :
         {Sheet{{0, 50, 0}, {0, 0, 0.3}, true}, Sheet{{0, 50, 0}, {0, 0.02, 0.3}, true},
          Sheet{{0, 50, 0}, {0, 0, 0.015}, true}, Sheet{{0, 50, 0}, {0, 0.3, 0}, false},
          Sheet{{0, 50, 0}, {0, -0.3, 0}, false}, Sheet{{0, 50, 0}, {0, 0, 0.005}, false},
          Sheet{{0, 50, 0}, {0, 0, 0}, false}, Sheet{{0, 50, 0}, {0, 0.2, 0.2}, false}}) {
        ModelBuilder builder;
        flat_sheet(builder, {0, 50, 0});
        flat_sheet(builder, other.across, other.shift);
        const MeasuredSeam seam = measured(builder.build()).at(0);
        EXPECT_EQ(seam.kind, SeamClass::fold);
        EXPECT_EQ(seam.verdict, Verdict::fail);
        EXPECT_EQ(seam.stacked, other.stacked) << other.shift.y << ", " << other.shift.z;
    }
    // No fold, but two sheets; one continues the other at another height.
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    flat_sheet(builder, {0, -50, 0}, {0, 0, 0.3});
    EXPECT_FALSE(only_seam(builder).stacked);
}

TEST(MeasureSeams, DoesNotCareHowTheSidesAreParametrised) {
    const Vec3 along(sheet_length, 0, 0), a(0, 50, 0), b = down(0.2);
    for (int i = 0; i < 16; ++i) {
        // Each side from either end, and with u and v exchanged: all orientations of du x dv.
        const auto add = [](ModelBuilder& builder, bool swap, bool back, Vec3 u, Vec3 v) {
            Vec3 origin(0);
            if (back) origin = u, u = -u;
            swap ? builder.plane(origin, v, u) : builder.plane(origin, u, v);
        };
        ModelBuilder builder;
        add(builder, i & 1, i & 2, along, a);
        add(builder, i & 4, i & 8, along, b);
        EXPECT_NEAR(only_seam(builder).angle->value, 0.2, 1e-9) << i;
    }
}

TEST(MeasureSeams, MeasuresAcrossAMirroredInstance) {
    ModelBuilder builder;
    flat_sheet(builder, down(1.5));
    builder.instance({});
    Affine mirror;
    mirror.rows[1] = Vec3(0, -1, 0);
    builder.instance(mirror);
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.angle->value, 3, 1e-9);
    EXPECT_EQ(seam.instance_a, 0u);
    EXPECT_EQ(seam.instance_b, 1u);
}

TEST(MeasureSeams, FindsNothingBetweenTangentPiecesOfOneCylinder) {
    ModelBuilder builder;
    builder.rational_patch(1, 2, arc_sheet(0, 80, pi / 2, pi));
    builder.rational_patch(1, 2, arc_sheet(0, 80, 0, pi / 2));
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.gap.value, 0, 1e-12);
    EXPECT_NEAR(seam.angle->value, 0, 1e-9);
    ASSERT_TRUE(seam.curvature.has_value());
    EXPECT_NEAR(std::abs(seam.curvature->curvature_a), 1 / 80.0, 1e-14);
    EXPECT_NEAR(seam.curvature->mismatch, 0, 1e-11);
    EXPECT_EQ(seam.verdict, Verdict::pass);
}

TEST(MeasureSeams, ComparesCurvaturesByTheFormulaOfThePreset) {
    ModelBuilder builder;
    builder.rational_patch(1, 2, arc_sheet(0, 100, pi / 2, pi));
    builder.rational_patch(1, 2, arc_sheet(-2, 102, 0.2, pi / 2));
    const MeasuredSeam outer = only_seam(builder);
    EXPECT_NEAR(outer.curvature->mismatch, 2.0 / 202, 1e-12);
    EXPECT_EQ(outer.verdict, Verdict::pass);
    CriteriaPreset strict = preset_by_name("class-a-strict");
    EXPECT_NEAR(only_seam(builder, strict).curvature->mismatch, 2.0 / 102, 1e-12);
    strict.curvature->limit = 0.0195;
    EXPECT_EQ(only_seam(builder, strict).verdict, Verdict::fail);
}

TEST(MeasureSeams, CountsAnInflectionAsAFullMismatch) {
    ModelBuilder builder;
    builder.rational_patch(1, 2, arc_sheet(0, 100, pi / 2, 2));
    builder.rational_patch(1, 2, arc_sheet(200, 100, 3 * pi / 2, 5));
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.angle->value, 0, 1e-9);
    EXPECT_NEAR(seam.curvature->mismatch, 1, 1e-9);
    EXPECT_NEAR(seam.curvature->curvature_a, -seam.curvature->curvature_b, 1e-14);
    EXPECT_EQ(seam.verdict, Verdict::fail);
}

TEST(MeasureSeams, ComparesNearlyFlatSidesWithTheFlatRadius) {
    const auto against_plane = [](double radius) {
        ModelBuilder builder;
        builder.rational_patch(1, 2, arc_sheet(-radius, radius, pi / 2, pi / 2 + 100 / radius));
        flat_sheet(builder, {0, 50, 0});
        return only_seam(builder);
    };
    const MeasuredSeam nearly_flat = against_plane(600e3);
    EXPECT_TRUE(nearly_flat.curvature->flat);
    EXPECT_NEAR(nearly_flat.curvature->worst.value, (1 / 600e3) / (2 / 100e3), 1e-6);
    EXPECT_EQ(nearly_flat.verdict, Verdict::pass);
    EXPECT_EQ(against_plane(400e3).verdict, Verdict::fail);
    EXPECT_FALSE(against_plane(40e3).curvature->flat);
}

TEST(MeasureSeams, FindsTheWidestPlaceOfACurvedGap) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = sheet_length * double(i) / 3;
        points.push_back({x, -0.5 * hump[i], 0});
        points.push_back({x, -50, 0});
    }
    builder.patch(3, 1, points);
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.gap.value, 0.5 * peak, 1e-12);
    EXPECT_NEAR(seam.gap.place.x, sheet_length * 2 / 3, 1e-4);
    EXPECT_LT(seam.gap.bound, 1e-5);
}

TEST(MeasureSeams, FollowsAGapBeyondTheJoinDistance) {
    // A wedge that opens to `widest` mm, and a bulge in the middle.
    for (const double widest : {0.785, 3.2}) {
        ModelBuilder wedge;
        flat_sheet(wedge, {0, 50, 0});
        wedge.patch(1, 1,
                    {{0, 0, 0}, {0, -50, 0}, {sheet_length, -widest, 0}, {sheet_length, -50, 0}});
        const MeasuredSeam seam = only_seam(wedge);
        EXPECT_NEAR(seam.gap.value, widest, 1e-3 * widest);
        EXPECT_TRUE(seam.parted);
        EXPECT_NEAR(seam.length, sheet_length, 1e-6);

        ModelBuilder bulge;
        flat_sheet(bulge, {0, 50, 0});
        std::vector<Vec3> points;
        for (const auto& [share, height] :
             {std::pair(0.0, 0.0), std::pair(0.5, 2 * widest), std::pair(1.0, 0.0)}) {
            points.push_back({sheet_length * share, -height, 0});
            points.push_back({sheet_length * share, -50, 0});
        }
        bulge.patch(2, 1, points);
        const MeasuredSeam bulged = only_seam(bulge);
        EXPECT_NEAR(bulged.gap.value, widest, 1e-6);
        EXPECT_TRUE(bulged.parted);
        EXPECT_NEAR(bulged.length, sheet_length, 1e-6);
    }
}

TEST(MeasureSeams, StillJudgesTheGapOfACrease) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0}, {0, 0, 0.02});
    flat_sheet(builder, down(60));
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_EQ(seam.kind, SeamClass::crease);
    EXPECT_FALSE(seam.curvature.has_value());
    EXPECT_EQ(seam.verdict, Verdict::fail);
}

TEST(MeasureSeams, IsUndecidedWhereAnApproximationStraddlesTheLimit) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0}, {0, 0.012, 0});
    flat_sheet(builder, {0, -50, 0});
    SurfaceModel model = builder.build();
    EXPECT_EQ(measured(model).at(0).verdict, Verdict::fail);
    model.faces[1].approximated = 0.005;
    EXPECT_EQ(measured(model).at(0).verdict, Verdict::undecided);
    model.faces[1].approximated = 0.001;
    EXPECT_EQ(measured(model).at(0).verdict, Verdict::fail);
}

TEST(MeasureSeams, IsNotMisledByThePolesOfASphere) {
    const double w = std::sqrt(0.5);
    std::vector<Vec4> octant{{10, 0, 0, 1},          {10 * w, 0, 10 * w, w}, {0, 0, 10, 1},
                             {10 * w, 10 * w, 0, w}, {5, 5, 5, 0.5},         {0, 0, 10 * w, w},
                             {0, 10, 0, 1},          {0, 10 * w, 10 * w, w}, {0, 0, 10, 1}};
    // Off the axis, so that the collapsed side is one only to rounding.
    const Affine place = Affine::translate({3.1, 0.7, 0.3}) * Affine::rotate({1, 2, 3}, 1.1);
    const Affine turn = place * Affine::rotate({0, 0, 1}, pi / 2);
    ModelBuilder builder;
    for (const Affine& map : {place, turn}) {
        std::vector<Vec4> points;
        for (const Vec4& p : octant) points.push_back(map.homogeneous(p));
        builder.rational_patch(2, 2, points);
    }
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_NEAR(seam.length, 5 * pi, 1e-9);
    EXPECT_NEAR(seam.gap.value, 0, 1e-12);
    EXPECT_LT(seam.angle->value, 1e-5);
    EXPECT_NEAR(std::abs(seam.curvature->curvature_a), 0.1, 1e-6);
    EXPECT_EQ(seam.verdict, Verdict::pass);
}

TEST(MeasureSeams, ChainsThePiecesOfOneEdge) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    builder.polygon({{0, 0}, {0.2, 0}, {0.7, 0}, {1, 0}, {1, 1}, {0, 1}});
    flat_sheet(builder, down(0.5));
    builder.polygon({{0, 0}, {0.4, 0}, {1, 0}, {1, 1}, {0, 1}});
    const MeasuredSeam seam = only_seam(builder);
    EXPECT_EQ(seam.pieces.size(), 4u);
    EXPECT_NEAR(seam.length, sheet_length, 1e-10);
    EXPECT_NEAR(seam.angle->value, 0.5, 1e-9);
    EXPECT_EQ(seam.faces, "face 1 | face 2");
    EXPECT_NEAR(seam.middle.y, 0, 1e-12);
}

TEST(MeasureSeams, PartsASeamAtACorner) {
    ModelBuilder builder;
    flat_sheet(builder, {0, 50, 0});
    builder.polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    builder.polygon({{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.8}, {0.4, 0.8}});
    builder.plane({40, 20, 0}, {20, 0, 0}, {0, 20, 0}); // fills the hole
    EXPECT_EQ(measured(builder.build()).size(), 4u);
}

/// The parabolic sheet z = bend y^2 + twist y^3 beside y = 0, `sign` y from 0 to 20.
void cubic_sheet(ModelBuilder& builder, double sign, double bend, double twist) {
    const double y = 20 * sign;
    std::vector<Vec3> points;
    for (const double x : {0.0, sheet_length})
        for (const Vec3& p :
             {Vec3(x, 0, 0), Vec3(x, y / 3, 0), Vec3(x, 2 * y / 3, bend * y * y / 3),
              Vec3(x, y, bend * y * y + twist * y * y * y)})
            points.push_back(p);
    builder.patch(1, 3, points);
}

TEST(MeasureSeams, GivesTheChangeOfTheCurvaturesSlope) {
    ModelBuilder builder;
    cubic_sheet(builder, 1, 0.001, 2e-6); // k = 0.002 and k' = 1.2e-5 at y = 0
    cubic_sheet(builder, -1, 0.001, 1e-6);
    const MeasuredSeam seam = only_seam(builder);
    ASSERT_TRUE(seam.slope.has_value());
    EXPECT_NEAR(seam.slope->change, 6e-6, 1e-15);
    const double angle = std::atan2(1.2e-5, 4e-6) - std::atan2(6e-6, 4e-6);
    EXPECT_NEAR(seam.slope->worst.value, radians_to_degrees(angle), 1e-7);
    EXPECT_EQ(seam.verdict, Verdict::pass); // class-a-outer does not judge it
    EXPECT_EQ(only_seam(builder, preset_by_name("class-a-strict")).verdict, Verdict::fail);
}

TEST(MeasureSeams, FindsNoChangeOfSlopeInOneCubicCutInTwo) {
    ModelBuilder builder;
    cubic_sheet(builder, 1, 0.001, 2e-6);
    cubic_sheet(builder, -1, 0.001, 2e-6);
    const MeasuredSeam seam = only_seam(builder, preset_by_name("class-a-strict"));
    ASSERT_TRUE(seam.slope.has_value());
    EXPECT_NEAR(seam.slope->worst.value, 0, 1e-9);
    EXPECT_EQ(seam.verdict, Verdict::pass);
}

TEST(MeasureSeams, TellsAnOverlapFromAGap) {
    for (const double apart : {0.02, -0.02}) {
        ModelBuilder builder;
        flat_sheet(builder, {0, 50, 0}, {0, apart, 0});
        flat_sheet(builder, {0, -50, 0});
        const MeasuredSeam seam = only_seam(builder);
        EXPECT_NEAR(seam.gap.value, 0.02, 1e-13);
        EXPECT_EQ(seam.overlap, apart < 0);
    }
}

} // namespace
} // namespace keiko
