#include "keiko/geometry/bezier/differential_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

using namespace keiko;

namespace {

/// An octant of a sphere about the origin as a rational biquadratic patch; the edge v = 1 is
/// collapsed to the pole (0, 0, radius).
std::vector<Vec4> sphere_octant(double radius) {
    const double c = std::numbers::sqrt2 / 2;
    const std::vector<Vec3> equator{{1, 0, 1}, {c, c, c}, {0, 1, 1}};  // x y w
    const std::vector<Vec3> meridian{{1, 0, 1}, {c, c, c}, {0, 1, 1}}; // radial z w
    std::vector<Vec4> points;
    for (const Vec3& e : equator)
        for (const Vec3& m : meridian)
            points.emplace_back(radius * e.x * m.x, radius * e.y * m.x, radius * e.z * m.y,
                                e.z * m.z);
    return points;
}

} // namespace

TEST(DifferentialGeometry, SphereHasItsRadiusEverywhere) {
    const double radius = 40;
    const auto points = sphere_octant(radius);
    const BezierPatchView patch{2, 2, points};
    for (const Vec2& uv : {Vec2(0.1, 0.2), Vec2(0.5, 0.5), Vec2(0.9, 0.95)}) {
        const SurfaceDerivatives s = evaluate(patch, uv, 2);
        const auto normal = unit_normal(s, uv);
        ASSERT_TRUE(normal);
        EXPECT_LE((*normal - s.position() / radius).length(), 1e-13);
        const PrincipalCurvatures k = principal_curvatures(s, *normal);
        EXPECT_NEAR(k.k1, -1 / radius, 1e-8 / radius); // bends away from the outward normal
        EXPECT_NEAR(k.k2, -1 / radius, 1e-8 / radius);
        EXPECT_NEAR(k.gaussian(), 1 / (radius * radius), 1e-13);
        EXPECT_NEAR(normal_curvature(s, *normal, s.du() + s.dv() * 0.3), -1 / radius, 1e-13);
    }
}

TEST(DifferentialGeometry, NormalExistsAtACollapsedEdge) {
    const auto points = sphere_octant(40);
    for (const double u : {0.0, 0.4, 1.0}) {
        const Vec2 pole(u, 1);
        const auto normal = unit_normal(evaluate({2, 2, points}, pole, 2), pole);
        ASSERT_TRUE(normal);
        EXPECT_LE((*normal - Vec3(0, 0, 1)).length(), 1e-12);
    }
}

TEST(DifferentialGeometry, CurvaturesNearAPoleAreRightOrUnknown) {
    const double radius = 100;
    const auto points = sphere_octant(radius);
    for (int digits = 0; digits <= 17; ++digits) {
        const Vec2 uv(0.3, 1 - std::pow(10, -digits));
        const SurfaceDerivatives s = evaluate({2, 2, points}, uv, 2);
        const auto normal = unit_normal(s, uv);
        ASSERT_TRUE(normal);
        const auto k = reliable_curvatures(s, *normal);
        ASSERT_TRUE(k || digits > 5) << digits;
        ASSERT_FALSE(k && digits >= 8) << digits;
        if (!k) continue;
        EXPECT_NEAR(k->k1, -1 / radius, 1e-3 / radius) << digits;
        EXPECT_NEAR(k->k2, -1 / radius, 1e-3 / radius) << digits;
    }
}

/// The form along any way is that of the frame's: II(w, w) = xx c^2 + 2 xy c s + yy s^2.
TEST(DifferentialGeometry, SecondFormTellsTheCurvatureAlongEveryWay) {
    const std::vector<Vec4> points{{0, 0, 0, 1}, {1, 5, 2, 1},  {0, 9, 0, 1},
                                   {6, 0, 1, 1}, {5, 5, 4, 1},  {6, 10, 3, 1},
                                   {9, 1, 0, 1}, {10, 4, 1, 1}, {11, 9, 5, 1}};
    const Vec2 uv(0.3, 0.6);
    const SurfaceDerivatives s = evaluate({2, 2, points}, uv, 2);
    const Vec3 normal = unit_normal(s, uv).value();
    const Vec3 x = s.dv().normalized(), y = normal.cross(x);
    const SecondForm form = second_form(s, normal, s.dv());
    for (const double angle : {0.0, 0.7, 1.6, 2.5}) {
        const double c = std::cos(angle), d = std::sin(angle);
        EXPECT_NEAR(normal_curvature(s, normal, x * c + y * d),
                    form.xx * c * c + 2 * form.xy * c * d + form.yy * d * d, 1e-14);
    }
}

TEST(DifferentialGeometry, CylinderBendsOneWayOnly) {
    const double c = std::numbers::sqrt2 / 2, radius = 8;
    std::vector<Vec4> points;
    for (const Vec3& arc : {Vec3(1, 0, 1), Vec3(c, c, c), Vec3(0, 1, 1)})
        for (const double z : {0.0, 20.0})
            points.emplace_back(radius * arc.x, radius * arc.y, z * arc.z, arc.z);
    const Vec2 uv(0.3, 0.6);
    const SurfaceDerivatives s = evaluate({2, 1, points}, uv, 2);
    const Vec3 normal = unit_normal(s, uv).value();
    const PrincipalCurvatures k = principal_curvatures(s, normal);
    EXPECT_NEAR(k.k1, 0, 1e-12);
    EXPECT_NEAR(k.k2, -1 / radius, 1e-12);
    EXPECT_NEAR(normal_curvature(s, normal, s.du() / s.du().length() + s.dv() / 20), -0.5 / radius,
                1e-12);
}

TEST(DifferentialGeometry, NoNormalWhereThePatchIsAPoint) {
    const std::vector<Vec4> points(9, Vec4(1, 2, 3, 1));
    EXPECT_FALSE(unit_normal(evaluate({2, 2, points}, {0.5, 0.5}, 2), {0.5, 0.5}));
}
