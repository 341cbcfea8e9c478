#include "keiko/geometry/bezier/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace keiko;

namespace {

struct RandomPatch {
    int degree_u, degree_v;
    std::vector<Vec4> points;

    BezierPatchView view() const { return {degree_u, degree_v, points}; }
};

RandomPatch random_patch(std::mt19937& random, int degree_u, int degree_v) {
    std::uniform_real_distribution<double> jitter(-0.5, 0.5), weight(0.5, 2);
    RandomPatch patch{degree_u, degree_v, {}};
    for (int i = 0; i <= degree_u; ++i)
        for (int j = 0; j <= degree_v; ++j) {
            const double w = weight(random);
            patch.points.emplace_back((i + jitter(random)) * w, (j + jitter(random)) * w,
                                      jitter(random) * w, w);
        }
    return patch;
}

/// de Casteljau by the definition, in long double: the second implementation.
Vec3 de_casteljau(const RandomPatch& patch, double u, double v) {
    using Point = std::array<long double, 4>;
    const auto collapse = [](std::vector<Point> row, long double t) {
        for (std::size_t n = row.size(); n > 1; --n)
            for (std::size_t i = 0; i + 1 < n; ++i)
                for (std::size_t c = 0; c < 4; ++c)
                    row[i][c] = (1 - t) * row[i][c] + t * row[i + 1][c];
        return row.front();
    };
    std::vector<Point> column;
    for (int i = 0; i <= patch.degree_u; ++i) {
        std::vector<Point> row;
        for (int j = 0; j <= patch.degree_v; ++j) {
            const Vec4& p = patch.view().point(i, j);
            row.push_back({p.x, p.y, p.z, p.w});
        }
        column.push_back(collapse(row, v));
    }
    const Point p = collapse(column, u);
    return {static_cast<double>(p[0] / p[3]), static_cast<double>(p[1] / p[3]),
            static_cast<double>(p[2] / p[3])};
}

} // namespace

TEST(BezierPatch, AgreesWithDeCasteljauUpToDegree25) {
    std::mt19937 random(1);
    for (const auto& [degree_u, degree_v] :
         {std::pair{1, 1}, std::pair{3, 3}, {5, 2}, {12, 7}, {25, 25}}) {
        const RandomPatch patch = random_patch(random, degree_u, degree_v);
        for (const Vec2& uv : {Vec2(0, 0), Vec2(1, 0), Vec2(0.3, 0.8), Vec2(0.999, 0.5)}) {
            const Vec3 error =
                evaluate(patch.view(), uv, 0).position() - de_casteljau(patch, uv.x, uv.y);
            EXPECT_LE(error.length(), 1e-14 * (1 + degree_u + degree_v)) << degree_u;
        }
    }
}

TEST(BezierPatch, DerivativesAreThoseOfTheLowerOnes) {
    std::mt19937 random(2);
    const double h = 1e-5;
    for (const auto& [degree_u, degree_v] : {std::pair{1, 2}, {3, 3}, {5, 4}, {9, 8}}) {
        const RandomPatch patch = random_patch(random, degree_u, degree_v);
        const Vec2 uv(0.37, 0.61);
        const SurfaceDerivatives here = evaluate(patch.view(), uv, 3);
        const auto at = [&](double du, double dv) {
            return evaluate(patch.view(), uv + Vec2(du, dv), 3);
        };
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t l = 0; k + l < 3; ++l) {
                const Vec3 by_u = (at(h, 0).d[k][l] - at(-h, 0).d[k][l]) / (2 * h);
                const Vec3 by_v = (at(0, h).d[k][l] - at(0, -h).d[k][l]) / (2 * h);
                const double scale = 1 + here.d[k + 1][l].length() + here.d[k][l + 1].length();
                EXPECT_LE((here.d[k + 1][l] - by_u).length(), 2e-8 * scale) << k << l;
                EXPECT_LE((here.d[k][l + 1] - by_v).length(), 2e-8 * scale) << k << l;
            }
    }
}

TEST(BezierPatch, HullHoldsThePatch) {
    std::mt19937 random(3);
    const RandomPatch patch = random_patch(random, 4, 3);
    const Box3 hull = hull_bounds(patch.view());
    for (double u = 0; u <= 1; u += 0.05)
        for (double v = 0; v <= 1; v += 0.05)
            EXPECT_TRUE(hull.contains(evaluate(patch.view(), {u, v}, 0).position()));
}

TEST(BezierCurve, RationalArcStaysOnItsCircle) {
    const double c = std::cos(0.6), radius = 5;
    const Vec2 from(radius * std::cos(-0.6), radius * std::sin(-0.6)), middle(radius / c, 0);
    const std::vector<Vec3> arc{
        {from.x, from.y, 1}, {middle.x * c, middle.y * c, c}, {from.x, -from.y, 1}};
    for (double t = 0; t <= 1; t += 0.1) {
        const auto d = evaluate(BezierCurveView{arc}, t, 2);
        EXPECT_NEAR(d[0].length(), radius, 1e-14 * radius);
        EXPECT_NEAR(d[0].dot(d[1]), 0, 1e-12);
        const double curvature = std::abs(d[1].cross(d[2])) / std::pow(d[1].length(), 3);
        EXPECT_NEAR(curvature, 1 / radius, 1e-13);
    }
}
