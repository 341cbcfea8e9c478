#include "keiko/geometry/bezier/interpolation.h"

#include "keiko/geometry/bezier/bezier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

std::vector<Vec3> arc_points(double radius, int count, double angle) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double t = angle * i / (count - 1);
        points.emplace_back(radius * std::cos(t), radius * std::sin(t), 5);
    }
    return points;
}

/// Place and derivatives of a cubic Bezier span of unit weights at a share of it.
Vec3 at(const BezierSpan<Vec4>& span, double t) {
    std::vector<Vec4> p = span.points;
    for (std::size_t left = p.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i) p[i] = p[i] * (1 - t) + p[i + 1] * t;
    return euclidean(p.front());
}

TEST(InterpolatingSpline, PassesThroughItsPoints) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {5, 2, 1}, {5.5, 2, 3}, {20, -4, 3}};
    const auto spans = bezier_spans(interpolating_spline(points).curve);
    ASSERT_EQ(spans.size(), points.size() - 1);
    for (std::size_t i = 0; i < spans.size(); ++i) {
        EXPECT_LT((at(spans[i], 0) - points[i]).length(), 1e-12);
        EXPECT_LT((at(spans[i], 1) - points[i + 1]).length(), 1e-12);
    }
}

TEST(InterpolatingSpline, HasContinuousCurvature) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 2, 0}, {5, 2, 1}, {5.5, 2, 3}, {20, -4, 3}};
    const auto spans = bezier_spans(interpolating_spline(points).curve);
    for (std::size_t i = 0; i + 1 < spans.size(); ++i) {
        const auto &a = spans[i].points, &b = spans[i + 1].points;
        const double ha = spans[i].end - spans[i].begin, hb = spans[i + 1].end - spans[i + 1].begin;
        EXPECT_LT(((a[3] - a[2]) / ha - (b[1] - b[0]) / hb).length(), 1e-12);
        EXPECT_LT(
            ((a[3] - a[2] * 2 + a[1]) / (ha * ha) - (b[2] - b[1] * 2 + b[0]) / (hb * hb)).length(),
            1e-12);
    }
}

TEST(InterpolatingSpline, NearsACircleWithTheFourthPowerOfTheStep) {
    const auto error = [](int count) {
        double worst = 0;
        const auto points = arc_points(100, count, 1);
        for (const auto& span : bezier_spans(interpolating_spline(points).curve))
            for (double t = 0; t <= 1; t += 0.125) {
                const Vec3 place = at(span, t);
                worst = std::max(worst, std::abs(std::hypot(place.x, place.y) - 100));
            }
        return worst;
    };
    EXPECT_LT(error(11), 2e-3);
    EXPECT_LT(error(21), error(11) / 6);
    EXPECT_LT(error(41), error(21) / 6);
}

TEST(InterpolatingSpline, DepartsFromTheChordsByTheSagittaOfACircle) {
    const double angle = 0.1, radius = 100;
    const double sagitta = radius * (1 - std::cos(angle / 2));
    const InterpolatedCurve fit = interpolating_spline(arc_points(radius, 11, 10 * angle));
    double measured = 0;
    for (const auto& span : bezier_spans(fit.curve)) {
        const Vec3 a = at(span, 0), chord = at(span, 1) - a;
        for (double t = 0; t <= 1; t += 1.0 / 64)
            measured = std::max(measured, square_to(at(span, t) - a, chord).length());
    }
    EXPECT_NEAR(measured, sagitta, 0.05 * sagitta);
    EXPECT_GE(fit.departure, measured);
    EXPECT_LT(fit.departure, 1.1 * measured);
}

TEST(InterpolatingSpline, OfTwoPointsIsTheLineBetweenThem) {
    const InterpolatedCurve fit =
        interpolating_spline(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}, {3, 4, 0}});
    EXPECT_EQ(fit.curve.degree, 1);
    EXPECT_EQ(fit.curve.knots, (std::vector<double>{0, 0, 5, 5}));
    EXPECT_EQ(fit.departure, 0);
}

TEST(InterpolatingPolyline, KeepsEveryPointAndLeavesNoChord) {
    const auto points = arc_points(10, 7, 2);
    const InterpolatedCurve fit = interpolating_polyline(points);
    ASSERT_EQ(fit.curve.points.size(), points.size());
    EXPECT_EQ(fit.curve.knots.size(), points.size() + 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(euclidean(fit.curve.points[i]), points[i]);
    EXPECT_EQ(fit.departure, 0);
}

} // namespace
} // namespace keiko
