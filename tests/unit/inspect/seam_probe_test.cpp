#include "keiko/inspect/seams/seam_probe.h"

#include "keiko/import/worker/load_model.h"
#include "keiko/inspect/seams/knot_piece.h"

#include "tests/support/paths.h"
#include "tests/unit/inspect/sheets.h"
#include "tests/unit/inspect/sloped_seam.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

/// Share: knots, and so patch changes, are one within 1e-9 of a face's parameters.
constexpr double same_share = 1e-8;

/// mm: chords of side a between evenly spaced parameters. It is short by a share of about
/// (chord / radius of curvature)^2 / 24.
double sum_of_chords(const SeamProbe& probe, int count) {
    double sum = 0;
    Vec3 before = probe.place(probe.begin());
    for (int i = 1; i <= count; ++i) {
        const Vec3 after = probe.place(probe.begin() + (probe.end() - probe.begin()) * i / count);
        sum += (after - before).length();
        before = after;
    }
    return sum;
}

TEST(SeamProbe, LengthIsASumOfFineChordsThroughManyPatches) {
    const SurfaceModel panel = load_model(test::repository("surfaces/cage-panel.obj"));
    const BoundaryCurves curves(panel);
    const std::vector<Seam> seams = pair_seams(panel, 0.5);
    ASSERT_GT(seams.size(), 20U);
    for (const Seam& seam : seams) {
        const SeamProbe probe(curves, seam);
        const double fine = sum_of_chords(probe, 20000);
        EXPECT_NEAR(probe.length(), fine, same_share * fine) << seam.a.face << " | " << seam.b.face;
    }
}

/// A flat sheet along x whose speed changes from 10 to 90 mm a share of `knot`.
NurbsSurface uneven_sheet(double knot, double across) {
    NurbsSurface sheet{1, 1, {0, 0, knot, 1, 1}, {0, 0, 1, 1}, {}};
    for (const double x : {0.0, 10.0, 100.0})
        for (const double y : {0.0, across}) sheet.points.emplace_back(x, y, 0, 1);
    return sheet;
}

TEST(SeamProbe, LengthIsExactWhereTheSpeedOfAStraightBorderJumps) {
    test::ModelBuilder builder;
    builder.nurbs(uneven_sheet(0.37, 50));
    builder.nurbs(uneven_sheet(0.61, -50));
    const SurfaceModel model = builder.build();
    const BoundaryCurves curves(model);
    const SeamProbe probe(curves, test::first_sides());
    EXPECT_NEAR(probe.length(), 100, same_share * 100);
    // The other side changes at the same place.
    ASSERT_EQ(probe.patch_changes().size(), 2U);
    EXPECT_NEAR(probe.patch_changes()[0], 0.37, same_share);
    EXPECT_NEAR(probe.patch_changes()[1], 0.37, same_share);
    const SeamProbe begin = probe.part(probe.at(0), probe.at(0.3));
    EXPECT_TRUE(begin.patch_changes().empty());
    EXPECT_NEAR(begin.length(), 10 * 0.3 / 0.37, 1e-12);
    const SeamProbe end = probe.part(probe.at(0.3), probe.at(1));
    EXPECT_EQ(end.patch_changes().size(), 2U);
    EXPECT_NEAR(end.length(), 100 - 10 * 0.3 / 0.37, same_share * 100);
}

/// The largest angle of a bend between two lines of constant v of a face.
double largest_bend(const SurfaceModel& model, double low, double high) {
    const KnottedFace face(model, 0);
    const KnotPiece piece{
        .constant_u = false, .at = 0.5, .begin = 0, .end = 1, .low = low, .high = high};
    const auto left = piece.side(true), right = piece.side(false);
    const Affine unmoved;
    const SeamProbe probe = face.probe(piece, unmoved, left, right);
    double largest = 0;
    for (int i = 0; i < 1000; ++i)
        largest = std::max(largest, probe.at(i / 1000.0).angle.value_or(0));
    return largest;
}

TEST(SeamProbe, ABendIsNoneAtTheTipOfASmoothSheet) {
    // Of a propeller's blade, ruled between borders that meet at 90 degrees.
    test::ModelBuilder builder;
    builder.patch(3, 1,
                  {{-8.450211, -13.438821, -124.275493},
                   {-8.130676, -13.494609, -124.269447},
                   {-8.403287, -13.396758, -124.280044},
                   {-8.161321, -13.438125, -124.275584},
                   {-8.346922, -13.367117, -124.283234},
                   {-8.205514, -13.390627, -124.280711},
                   {-8.274301, -13.362243, -124.28375},
                   {-8.274301, -13.362243, -124.28375}});
    // A quarter of the least angle that a preset for outer panels allows.
    EXPECT_LT(largest_bend(builder.build(), 0.35, 0.65), 0.025);
}

TEST(SeamProbe, ABendIsStatedUpToTheTipOfASheet) {
    // Flat on either side of a line along x, about which it turns by 3 degrees. It is 0.1 mm long.
    const double slope = std::tan(degrees_to_radians(3));
    test::ModelBuilder builder;
    NurbsSurface tip{1, 1, {0, 0, 1, 1}, {0, 0, 0.5, 1, 1}, {}};
    for (const double x : {-0.1, 0.0})
        for (const double y : {x, 0.0, -x})
            tip.points.emplace_back(x, y, slope * std::max(0.0, y), 1);
    builder.nurbs(tip);
    const double bend = largest_bend(builder.build(), 0.4, 0.6);
    EXPECT_NEAR(bend, 3, 0.1);
}

TEST(SeamProbe, ABendIsTheWholeTurnWhereARadiusIsSmallerThanTheWayAcross) {
    // Sides apart by 0.8 and by 1.4 radii of a cylinder.
    for (const double radius : {10.0, 0.05}) {
        test::ModelBuilder builder;
        builder.rational_patch(1, 2, test::arc_sheet(0, radius, 0, std::numbers::pi / 2));
        const SurfaceModel model = builder.build();
        const auto angle = [&](double low, double high) {
            const KnottedFace face(model, 0);
            const KnotPiece piece{
                .constant_u = false, .at = 0.5, .begin = 0, .end = 1, .low = low, .high = high};
            const auto left = piece.side(true), right = piece.side(false);
            const Affine unmoved;
            return face.probe(piece, unmoved, left, right).at(0.5).angle;
        };
        EXPECT_LT(angle(0.25, 0.75).value_or(180), 2);
        EXPECT_NEAR(angle(0, 1).value_or(0), 90, 1e-6);
    }
}

/// No place of a bend states more than a face can turn by, however strongly it is curved.
TEST(SeamProbe, AnAngleIsNeverMoreThanThatOfAFold) {
    std::size_t told = 0;
    for (double height = 1e-3; height < 1e3; height *= 1.3) {
        test::ModelBuilder builder;
        builder.patch(1, 3,
                      {{0, 0, 0},
                       {0, 1, height},
                       {0, -0.9, height},
                       {0, 0.1, 0},
                       {100, 0, 0},
                       {100, 1, height},
                       {100, -0.9, height},
                       {100, 0.1, 0}});
        const SurfaceModel model = builder.build();
        for (double beside = 1e-3; beside < 0.5; beside *= 1.3) {
            const KnottedFace face(model, 0);
            const KnotPiece piece{.constant_u = false,
                                  .at = 0.5,
                                  .begin = 0,
                                  .end = 1,
                                  .low = 0.5 - beside,
                                  .high = 0.5 + beside};
            const auto left = piece.side(true), right = piece.side(false);
            const Affine unmoved;
            const auto angle = face.probe(piece, unmoved, left, right).at(0.5).angle;
            if (!angle) continue;
            ++told;
            EXPECT_LE(*angle, 180) << height << ", " << beside;
        }
    }
    EXPECT_GT(told, 100U);
}

} // namespace
} // namespace keiko
