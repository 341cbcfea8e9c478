#include "keiko/report/content/curve_sets.h"

#include "keiko/report/content/contour_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

/// A piece of a quarter circle of radius 100 about the origin, from one angle to another.
SurfaceLine arc(std::uint32_t face, double begin, double end) {
    SurfaceLine piece;
    piece.face = face;
    constexpr int steps = 10;
    for (int i = 0; i <= steps; ++i) {
        const double t = begin + (end - begin) * i / steps;
        piece.line.points.push_back({{}, {100 * std::cos(t), 100 * std::sin(t), 0}});
    }
    piece.line.deviation = 100 * (1 - std::cos((end - begin) / steps / 2));
    return piece;
}

/// One line of three pieces: two on face 0, then one on face 1 behind a failing seam.
LineList list_of_one_line() {
    LineList list;
    list.rig = "tunnel";
    list.views.resize(1);
    list.views[0].view = "front";
    JoinedLines& found = list.views[0].found;
    found.pieces = {arc(0, 0, 0.5), arc(0, 0.5, 1), arc(1, 1, 1.5)};
    found.lines.push_back(
        {.plane = 1, .lamp = 4, .pieces = {0, 1, 2}, .shapes = {}, .inflections = {}});
    LineCrossing crossing;
    crossing.line = 0, crossing.from = 1, crossing.to = 2;
    crossing.verdict = Verdict::fail;
    found.crossings.push_back(crossing);
    return list;
}

TEST(LineCurves, AreOneSplineAFaceAndCarryTheVerdict) {
    const CurveSet set = line_curves(list_of_one_line());
    ASSERT_EQ(set.curves.size(), 1u);
    const NamedCurve& curve = set.curves[0];
    // Twice the sagitta of a chord of 0.05 radians: 100 (1 - cos 0.025) mm.
    EXPECT_EQ(curve.name, "reflection line 0: fail, front, plane 1, lamp 4, within 0.0625 mm");
    ASSERT_EQ(curve.pieces.size(), 2u);
    EXPECT_EQ(curve.pieces[0].points.size(), 23u); // 21 points and two end tangents
    EXPECT_EQ(curve.pieces[1].points.size(), 13u);
    ASSERT_TRUE(curve.color);
    EXPECT_GT(curve.color->r, curve.color->g);
}

TEST(LineCurves, StateABoundOfTheirDistanceFromTheExactCurve) {
    const NamedCurve curve = line_curves(list_of_one_line()).curves.at(0);
    double worst = 0;
    for (const NurbsCurve<Vec4>& piece : curve.pieces)
        for (const BezierSpan<Vec4>& span : bezier_spans(piece)) {
            const Vec4 middle =
                (span.points[0] + span.points[1] * 3 + span.points[2] * 3 + span.points[3]) / 8;
            worst = std::max(worst, std::abs(euclidean(middle).length() - 100));
        }
    EXPECT_LT(worst, curve.deviation);
    EXPECT_GT(worst, 0);
}

TEST(LineCurves, BreakWhereTheFaceItselfBreaks) {
    LineList list = list_of_one_line();
    list.views[0].found.crossings[0].from = 0, list.views[0].found.crossings[0].to = 1;
    EXPECT_EQ(line_curves(list).curves.at(0).pieces.size(), 3u);
}

TEST(LineCurves, OfPointsThatASplineWouldLeaveArePolylines) {
    LineList list = list_of_one_line();
    SurfaceLine& zigzag = list.views[0].found.pieces[2];
    for (std::size_t i = 1; i < zigzag.line.points.size(); i += 2)
        zigzag.line.points[i].place.z += 5;
    const NamedCurve curve = line_curves(list).curves.at(0);
    EXPECT_EQ(curve.pieces[0].degree, 3);
    EXPECT_EQ(curve.pieces[1].degree, 1);
    EXPECT_EQ(curve.pieces[1].points.size(), 11u);
}

TEST(LineCurves, KeepOneOfPointsThatCrowd) {
    LineList list = list_of_one_line();
    std::vector<LinePoint>& points = list.views[0].found.pieces[2].line.points;
    points.insert(points.begin() + 1, points[0]);
    points[1].place.z += 1e-12;
    points.push_back(points.back());
    points.back().place.z += 1e-12;
    const NurbsCurve<Vec4> piece = line_curves(list).curves.at(0).pieces.at(1);
    EXPECT_EQ(piece.points.size(), 13u);
    EXPECT_EQ(euclidean(piece.points.back()), points.back().place);
}

TEST(LineCurves, WithoutACrossingAreNotJudged) {
    LineList list = list_of_one_line();
    list.views[0].found.crossings.clear();
    EXPECT_NE(line_curves(list).curves.at(0).name.find(": not judged,"), std::string::npos);
}

TEST(InspectionCurves, AreSectionsAndThenInflections) {
    CombCurve section{.name = "y=120", .pieces = {}};
    CombPiece piece;
    for (const SurfaceLine line = arc(0, 0, 1); const LinePoint& point : line.line.points)
        piece.samples.push_back({point.place, 0, {}});
    section.pieces.push_back(piece);
    Inspection inspection;
    inspection.facts.source = "hood.step";
    MeasuredFace face;
    face.name = "face 7";
    face.inflections.push_back({.deviation = 0.01, .points = {{0, 0, 0}, {3, 4, 0}}});
    inspection.faces.push_back(face);
    const CurveSet set = inspection_curves(inspection, {&section, 1}, 0.2);
    ASSERT_EQ(set.curves.size(), 2u);
    EXPECT_EQ(set.name, "hood.step");
    EXPECT_EQ(set.curves[0].name.substr(0, 22), "section y=120, within ");
    EXPECT_EQ(set.curves[0].pieces[0].degree, 3);
    EXPECT_EQ(set.curves[1].name, "face 7: inflection, within 0.01 mm");
    EXPECT_EQ(set.curves[1].pieces[0].degree, 1);
}

TEST(InspectionCurves, HaveStretchesOfSeamsWithVerdictsButNoScraps) {
    Inspection inspection;
    MeasuredSeam seam;
    seam.faces = "face 1 | face 2", seam.verdict = Verdict::fail;
    std::vector<Vec3> course; // an arc of radius 100 in steps of 0.02 radians
    for (int i = 0; i <= 32; ++i)
        course.emplace_back(100 * std::cos(0.02 * i), 100 * std::sin(0.02 * i), 0);
    seam.course = {course};
    MeasuredSeam scrap = seam;
    scrap.scrap = true;
    inspection.seams = {scrap, seam};
    const CurveSet set = inspection_curves(inspection, {}, 0.01);
    ASSERT_EQ(set.curves.size(), 1u);
    const NamedCurve& curve = set.curves[0];
    // Twice the sagitta of a step: 100 (1 - cos 0.01) mm.
    EXPECT_EQ(curve.name, "seam 2: fail, smooth, face 1 | face 2, within 0.01 mm");
    ASSERT_TRUE(curve.color);
    EXPECT_GT(curve.color->r, curve.color->g);
    EXPECT_EQ(curve.pieces.at(0).degree, 3);
}

TEST(ContourSet, NamesViewAndFace) {
    SurfaceModel model;
    Face face;
    face.id = 7;
    model.faces.push_back(face);
    model.instances.push_back({});
    const ContourLine contour{.deviation = 0.01, .points = {{0, 0, 0}, {3, 4, 0}}};
    const auto curves = contour_set(model, "front", {&contour, 1});
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].name, "contour: front, face 7, within 0.01 mm");
}

} // namespace
} // namespace keiko
