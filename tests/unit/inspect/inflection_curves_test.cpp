#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/basics/line_cells.h"
#include "keiko/inspect/curvature/face_measure.h"
#include "keiko/inspect/curvature/parabolic_field.h"

#include "tests/support/analytic_models.h"
#include "tests/unit/inspect/bernstein.h"
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace keiko {
namespace {

using std::numbers::pi;
using test::ModelBuilder;
using Powers = std::array<std::array<double, 5>, 5>; ///< of x^i y^k

/// The graph of a polynomial over [-half, half]^2.
SurfaceModel graph(const Powers& powers, double half) {
    std::array<std::array<double, 5>, 5> by_y{}, both{};
    for (std::size_t i = 0; i < 5; ++i) by_y[i] = test::bernstein(powers[i], -half, 2 * half);
    for (std::size_t k = 0; k < 5; ++k) {
        std::array<double, 5> column{};
        for (std::size_t i = 0; i < 5; ++i) column[i] = by_y[i][k];
        both[k] = test::bernstein(column, -half, 2 * half);
    }
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t k = 0; k < 5; ++k)
            points.emplace_back(half * (double(i) / 2 - 1), half * (double(k) / 2 - 1), both[k][i]);
    ModelBuilder builder;
    builder.patch(4, 4, points);
    return builder.build();
}

/// A ring of radius 100 whose tube of radius 30 is cut into quarters from the angle `first` on.
SurfaceModel torus(double first) {
    std::vector<Vec4> profile;
    for (int i = 0; i <= 8; ++i) {
        const double angle = first + i * pi / 4, w = i % 2 == 0 ? 1 : std::cos(pi / 4);
        profile.emplace_back(100 * w + 30 * std::cos(angle), 0, 30 * std::sin(angle), w);
    }
    ModelBuilder builder;
    builder.nurbs(test::revolution(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, profile));
    builder.instance(test::stretched(Vec3(1), {1, 2, 3}, {2000, -300, 500}));
    return builder.build();
}

void expect_rings(const SurfaceModel& model) {
    const std::vector<InflectionCurve> curves = inflection_curves(model, 0, 0);
    ASSERT_EQ(curves.size(), 2u);
    const Vec3 axis = Vec3(1, 2, 3).normalized(), middle(2000, -300, 500);
    double heights = 0;
    for (const InflectionCurve& curve : curves) {
        EXPECT_TRUE(curve.closed);
        EXPECT_TRUE(curve.proved);
        EXPECT_NEAR(curve.length, 2 * pi * 100, 0.05);
        EXPECT_NEAR(curve.rate, 1 / 3000.0, 1e-6 / 3000);
        EXPECT_LE(curve.deviation, 0.01);
        const double height = (curve.points.front() - middle).dot(axis);
        heights += height;
        EXPECT_NEAR(std::abs(height), 30, 1e-6);
        for (const Vec3& p : curve.points) {
            EXPECT_NEAR((p - middle).dot(axis), height, 1e-6);
            EXPECT_NEAR((p - middle).cross(axis).length(), 100, 1e-6);
        }
    }
    EXPECT_NEAR(heights, 0, 1e-6);
}

TEST(InflectionCurves, AreTheTopAndBottomRingsOfATorus) {
    expect_rings(torus(0.3));
}

/// Torus as CAD systems write it: at the rings the curvature is 0 along sides of patches.
TEST(InflectionCurves, AreFoundBetweenPatchesThatEndThere) {
    expect_rings(torus(0));
}

TEST(InflectionCurves, AreWhereACubicGraphTurnsOver) {
    Powers powers{};
    powers[3][0] = 1e-6, powers[0][2] = 1e-3; // z = 1e-6 x^3 + 1e-3 y^2, mm
    const auto curves = inflection_curves(graph(powers, 100), 0, 0);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_FALSE(curves[0].closed);
    EXPECT_TRUE(curves[0].proved);
    // Over y = -100 .. 100 a parabola of 1e-3 y^2.
    const double s = 0.2, arc = (s * std::hypot(1, s) + std::asinh(s)) / (2 * 1e-3);
    EXPECT_NEAR(curves[0].length, arc, 0.001);
    for (const Vec3& p : curves[0].points) EXPECT_NEAR(p.x, 0, 1e-7);
    EXPECT_NEAR(curves[0].rate, 6e-6, 1e-10); // z_xxx, where y is 0
}

/// z = a r^2 - b r^4 bends the other way along the radius where r^2 = a / (6 b).
TEST(InflectionCurves, AreTheRingAroundADome) {
    const double a = -1e-3, b = -1e-7;
    Powers powers{};
    powers[2][0] = powers[0][2] = a;
    powers[4][0] = powers[0][4] = -b, powers[2][2] = -2 * b;
    const double radius = std::sqrt(a / (6 * b)); // 40.8 mm
    const auto curves = inflection_curves(graph(powers, 45), 0, 0);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_TRUE(curves[0].closed);
    EXPECT_TRUE(curves[0].proved);
    for (const Vec3& p : curves[0].points) EXPECT_NEAR(std::hypot(p.x, p.y), radius, 1e-6);
    EXPECT_NEAR(curves[0].length, 2 * pi * radius, 0.05);
}

TEST(InflectionCurves, EndAtTrims) {
    Powers powers{};
    powers[3][0] = 1e-6, powers[0][2] = 1e-3;
    SurfaceModel model = graph(powers, 100);
    ModelBuilder builder;
    std::vector<Vec3> points;
    for (const Vec4& p : model.control_points) points.emplace_back(p.x, p.y, p.z);
    builder.patch(4, 4, points);
    builder.polygon({{0.1, 0.25}, {0.9, 0.25}, {0.9, 0.7}, {0.1, 0.7}});
    const auto curves = inflection_curves(builder.build(), 0, 0);
    ASSERT_EQ(curves.size(), 1u);
    double low = 1e9, high = -1e9;
    for (const Vec3& p : curves[0].points) low = std::min(low, p.y), high = std::max(high, p.y);
    EXPECT_NEAR(low, -50, 1e-6);
    EXPECT_NEAR(high, 40, 1e-6);
}

TEST(InflectionCurves, AreNotOnFacesThatBendOneWayOnly) {
    const Affine placed = test::stretched({40, 40, 100}, {1, 1, 2}, {900, 0, -1300});
    const Affine round = test::stretched(Vec3(40), {1, 1, 2}, {900, 0, -1300});
    ModelBuilder plane;
    plane.plane({0, 0, 500}, {1000, 0, 0}, {0, 700, 3});
    for (const SurfaceModel& model : {test::cylinder_model(placed), test::sphere_model(round),
                                      test::bonnet_model(1200, 1400, 80), plane.build()})
        EXPECT_TRUE(inflection_curves(model, 0, 0).empty());
}

/// Every change of sign between neighbours of a fine grid is in a cell.
TEST(FieldCells, HoldEveryChangeOfSign) {
    Powers powers{};
    powers[2][0] = 1e-3, powers[4][0] = -2e-7, powers[3][1] = 3e-7, powers[0][3] = 2e-6,
    powers[1][2] = -4e-6, powers[2][2] = 1e-7, powers[0][4] = 1e-8;
    const SurfaceModel model = graph(powers, 100);
    const auto field = parabolic_field(model.patch(0), 0);
    ASSERT_TRUE(field.has_value());
    const std::vector<LineCell> cells = field_cells(field->inner).cells;
    const auto gaussian = [&](const Vec2& uv) {
        const SurfaceDerivatives s = evaluate(model.patch(0), uv, 2);
        return principal_curvatures(s, s.du().cross(s.dv()).normalized()).gaussian();
    };
    const auto held = [&](const Vec2& uv) {
        return std::any_of(cells.begin(), cells.end(), [&](const LineCell& cell) {
            return cell.uv.padded(1e-12).contains(uv);
        });
    };
    constexpr int count = 300;
    int changes = 0;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < count; ++k) {
            Vec2 a((i + 0.5) / count, (k + 0.5) / count), b = a + Vec2(1.0 / count, 0);
            if (b.x > 1 || (gaussian(a) < 0) == (gaussian(b) < 0)) continue;
            ++changes;
            const bool below = gaussian(a) < 0;
            for (int halving = 0; halving < 60; ++halving) {
                const Vec2 middle = (a + b) / 2;
                ((gaussian(middle) < 0) == below ? a : b) = middle;
            }
            EXPECT_TRUE(held(a)) << a;
        }
    EXPECT_GT(changes, 200);
}

/// Against differences of the lesser curvature along the surface.
TEST(ParabolicRate, IsTheSlopeOfTheCurvatureAcrossTheCurve) {
    Powers powers{};
    powers[3][0] = 1e-6, powers[0][2] = 1e-3;
    const SurfaceModel model = graph(powers, 100);
    const double h = 1e-4; // of u, so 0.02 mm
    const auto lesser = [&](double u) {
        const SurfaceDerivatives s = evaluate(model.patch(0), {u, 0.7}, 2);
        const PrincipalCurvatures k = principal_curvatures(s, s.du().cross(s.dv()).normalized());
        return std::abs(k.k1) < std::abs(k.k2) ? k.k1 : k.k2;
    };
    const double slope = std::abs(lesser(0.5 + h) - lesser(0.5 - h)) / (400 * h);
    EXPECT_NEAR(parabolic_rate(evaluate(model.patch(0), {0.5, 0.7}, 3)), slope, 1e-6 * slope);
}

} // namespace
} // namespace keiko
