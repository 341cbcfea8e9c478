#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/cad/curve_spans.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Hyperbola.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_OffsetCurve.hxx>
#include <Geom2d_Parabola.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <gp_Ax22d.hxx>
#include <gp_Hypr2d.hxx>
#include <gp_Parab2d.hxx>
#include <gtest/gtest.h>

#include <cmath>

namespace keiko::cad {
namespace {

using Curve2d = opencascade::handle<Geom2d_Curve>;

/// Largest distance between pieces and curve; the pieces must follow each other over the range.
double deviation(const Curve2d& curve, double first, double last) {
    const CurveSpans<Vec3> converted = curve_spans(curve, first, last);
    EXPECT_EQ(converted.spans.front().map.begin, first);
    EXPECT_EQ(converted.spans.back().map.end, last);
    double worst = 0, reached = first;
    for (const CurveSpan<Vec3>& span : converted.spans) {
        EXPECT_EQ(span.map.begin, reached);
        reached = span.map.end;
        for (int i = 0; i <= 20; ++i) {
            const gp_Pnt2d wanted = curve->Value(span.map.to_face(i / 20.0));
            const Vec2 got = evaluate(BezierCurveView{span.points}, i / 20.0, 0)[0];
            worst = std::max(worst, (got - Vec2(wanted.X(), wanted.Y())).length());
        }
    }
    return worst;
}

const gp_Ax22d right_handed(gp_Pnt2d(1, -2), gp_Dir2d(0.6, 0.8), true);
const gp_Ax22d left_handed(gp_Pnt2d(1, -2), gp_Dir2d(0.6, 0.8), false);

TEST(CurveSpans, LinesAndConicsAreExact) {
    EXPECT_LT(deviation(new Geom2d_Line(gp_Pnt2d(3, 4), gp_Dir2d(1, 2)), -5, 7), 1e-14);
    for (const gp_Ax22d& axes : {right_handed, left_handed}) {
        const gp_Elips2d ellipse(axes, 3, 0.5);
        EXPECT_LT(deviation(new Geom2d_Circle(gp_Circ2d(axes, 2)), 0, 2 * M_PI + 4e-13), 1e-14);
        EXPECT_LT(deviation(new Geom2d_Circle(gp_Circ2d(axes, 2)), -9, -8.9), 1e-14);
        EXPECT_LT(deviation(new Geom2d_Ellipse(ellipse), 1, 12), 1e-13);
        EXPECT_LT(deviation(new Geom2d_Parabola(gp_Parab2d(axes, 0.7)), -3, 5), 1e-13);
        EXPECT_LT(deviation(new Geom2d_Hyperbola(gp_Hypr2d(axes, 2, 1)), -2, 1.5), 1e-12);
    }
}

opencascade::handle<Geom2d_BSplineCurve> cubic(bool periodic) {
    TColgp_Array1OfPnt2d poles(1, 7);
    TColStd_Array1OfReal weights(1, 7);
    for (int i = 1; i <= 7; ++i) {
        poles(i) = gp_Pnt2d(std::cos(i * 2 * M_PI / 7), 2 * std::sin(i * 2.1 * M_PI / 7));
        weights(i) = 1 + 0.3 * (i % 3);
    }
    const int spans = periodic ? 7 : 4;
    TColStd_Array1OfReal knots(1, spans + 1);
    TColStd_Array1OfInteger multiplicities(1, spans + 1);
    for (int i = 1; i <= spans + 1; ++i) knots(i) = i * i, multiplicities(i) = 1;
    if (!periodic) multiplicities(1) = multiplicities(spans + 1) = 4;
    return new Geom2d_BSplineCurve(poles, weights, knots, multiplicities, 3, periodic);
}

TEST(CurveSpans, SplinesAreExactOnAnyPart) {
    EXPECT_LT(deviation(cubic(false), 1, 25), 1e-13);
    EXPECT_LT(deviation(cubic(false), 2.5, 3.5), 1e-13);
    EXPECT_LT(deviation(cubic(false), 3.99, 16.01), 1e-13);
}

TEST(CurveSpans, ASplineIsContinuedBeyondItsEnds) {
    EXPECT_LT(deviation(cubic(false), 0.9, 25.1), 1e-12);
}

TEST(CurveSpans, APeriodicSplineMayBeAskedForAnyRange) {
    const double period = 63;
    EXPECT_LT(deviation(cubic(true), 1, 64), 1e-12);
    EXPECT_LT(deviation(cubic(true), 30, 30 + period), 1e-12);
    EXPECT_LT(deviation(cubic(true), -40, -1), 1e-12);
}

TEST(CurveSpans, ATrimmedCurveKeepsItsParameters) {
    const Curve2d circle = new Geom2d_Circle(gp_Circ2d(right_handed, 2));
    EXPECT_LT(deviation(new Geom2d_TrimmedCurve(circle, 1, 4), 1.5, 3), 1e-14);
}

TEST(CurveSpans, AnOffsetCurveIsApproximatedAndSaysSo) {
    const Curve2d offset = new Geom2d_OffsetCurve(cubic(false), 0.05);
    const auto converted = curve_spans(offset, 2, 20);
    EXPECT_GT(converted.approximated, 0);
    EXPECT_LT(converted.approximated, 1e-3);
}

} // namespace
} // namespace keiko::cad
