#include "keiko/geometry/bezier/nurbs.h"

#include "keiko/geometry/bezier/bezier.h"

#include <gtest/gtest.h>

#include <random>

using namespace keiko;

namespace {

/// Cox - de Boor by the recursive definition: slow, and nothing shared with knot insertion.
double basis(const std::vector<double>& knots, int i, int degree, double t) {
    const auto k = [&](int index) { return knots[static_cast<std::size_t>(index)]; };
    if (degree == 0) return k(i) <= t && t < k(i + 1) ? 1 : 0;
    double sum = 0;
    if (k(i + degree) > k(i))
        sum += (t - k(i)) / (k(i + degree) - k(i)) * basis(knots, i, degree - 1, t);
    if (k(i + degree + 1) > k(i + 1))
        sum += (k(i + degree + 1) - t) / (k(i + degree + 1) - k(i + 1)) *
               basis(knots, i + 1, degree - 1, t);
    return sum;
}

std::vector<Vec3> random_plane_points(std::size_t count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> at(-1, 1), weight(0.5, 2);
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double w = weight(random);
        points.emplace_back(at(random) * w, at(random) * w, w);
    }
    return points;
}

void expect_spans_follow(int degree, const std::vector<double>& knots) {
    const auto count = knots.size() - static_cast<std::size_t>(degree) - 1;
    const NurbsCurve<Vec3> curve{degree, knots, random_plane_points(count)};
    const auto spans = bezier_spans(curve);
    ASSERT_FALSE(spans.empty());
    EXPECT_EQ(spans.front().begin, knots[static_cast<std::size_t>(degree)]);
    EXPECT_EQ(spans.back().end, knots[count]);
    for (const auto& span : spans)
        for (const double s : {0.0, 0.25, 0.9}) {
            const double t = span.begin + s * (span.end - span.begin);
            Vec3 h(0);
            for (std::size_t i = 0; i < count; ++i)
                h += curve.points[i] * basis(knots, static_cast<int>(i), degree, t);
            const Vec2 expected = Vec2(h.x, h.y) / h.z;
            const Vec2 got = evaluate(BezierCurveView{span.points}, s, 0)[0];
            EXPECT_LE((expected - got).length(), 1e-13);
        }
    for (std::size_t i = 1; i < spans.size(); ++i) {
        EXPECT_EQ(spans[i - 1].end, spans[i].begin);
        EXPECT_EQ(spans[i - 1].points.back(), spans[i].points.front());
    }
}

} // namespace

TEST(BezierSpans, FollowAClampedCurve) {
    expect_spans_follow(3, {0, 0, 0, 0, 1, 2, 2, 3.5, 4, 4, 4, 4});
    expect_spans_follow(5, {0, 0, 0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1, 1, 1});
    expect_spans_follow(1, {0, 0, 1, 3, 3});
}

TEST(BezierSpans, FollowAnUnclampedCurve) {
    expect_spans_follow(3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    expect_spans_follow(2, {-1, 0, 0.5, 2, 2.25, 3, 5});
}

TEST(BezierSpans, KnotsOfFullMultiplicityGiveAKink) {
    expect_spans_follow(2, {0, 0, 0, 1, 1, 2, 2, 2});
    expect_spans_follow(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2});
}

TEST(BezierSpans, PatchesOfASurfaceShareTheirBordersBitForBit) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(-1, 1), weight(0.5, 2);
    NurbsSurface surface{3, 2, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}, {0, 0, 0, 0.5, 0.75, 1, 1, 1}, {}};
    for (std::size_t i = 0; i < surface.count_u() * surface.count_v(); ++i) {
        const double w = weight(random);
        surface.points.emplace_back(at(random) * w, at(random) * w, at(random) * w, w);
    }
    const auto patches = bezier_spans(surface);
    ASSERT_EQ(patches.size(), 9u);
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b + 1 < 3; ++b)
            for (std::size_t i = 0; i <= 3; ++i) {
                EXPECT_EQ(patches[a * 3 + b].points[i * 3 + 2],
                          patches[a * 3 + b + 1].points[i * 3]);
                if (i < 3) {
                    EXPECT_EQ(patches[b * 3 + a].points[9 + i], patches[(b + 1) * 3 + a].points[i]);
                }
            }
    const Vec2 knot_point(1.4, 0.6);
    Vec4 h(0);
    for (std::size_t i = 0; i < surface.count_u(); ++i)
        for (std::size_t j = 0; j < surface.count_v(); ++j)
            h += surface.points[i * surface.count_v() + j] *
                 (basis(surface.knots_u, static_cast<int>(i), 3, knot_point.x) *
                  basis(surface.knots_v, static_cast<int>(j), 2, knot_point.y));
    const BezierPatchSpan& patch = patches[4];
    const Vec2 uv((knot_point.x - patch.u_begin) / (patch.u_end - patch.u_begin),
                  (knot_point.y - patch.v_begin) / (patch.v_end - patch.v_begin));
    const Vec3 got = evaluate({3, 2, patch.points}, uv, 0).position();
    EXPECT_LE((got - Vec3(h.x, h.y, h.z) / h.w).length(), 1e-13);
}
