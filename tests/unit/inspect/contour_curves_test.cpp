#include "keiko/inspect/lines/contour_curves.h"

#include "tests/support/analytic_models.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

Camera camera_at(const Vec3& eye, Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.eye = eye, camera.target = Vec3(0), camera.up = {0, 0, 1};
    camera.orthographic_height = 100;
    return camera;
}

double total_length(const std::vector<ContourLine>& contours) {
    double length = 0;
    for (const ContourLine& contour : contours) length += contour.length;
    return length;
}

TEST(ContourCurves, OfASphereLieInThePlaneOfTheTangentCone) {
    constexpr double radius = 50, distance = 200;
    const SurfaceModel sphere = test::sphere_model(Affine::scale(radius));
    const LineEye eye(camera_at({distance, 0, 0}, Projection::perspective));
    const auto contours = contour_curves(sphere, eye);
    // The points of tangency of rays from the eye: a circle at x = R^2 / D.
    const double x = radius * radius / distance, r = std::sqrt(radius * radius - x * x);
    for (const ContourLine& contour : contours)
        for (const Vec3& p : contour.points) {
            EXPECT_NEAR(p.x, x, 1e-6);
            EXPECT_NEAR(p.length(), radius, 1e-9);
        }
    const double length = 2 * std::numbers::pi * r;
    EXPECT_LT(total_length(contours), length);
    EXPECT_NEAR(total_length(contours), length, 0.05);
}

TEST(ContourCurves, OfASphereFromAfarAreAGreatCircle) {
    const SurfaceModel sphere = test::sphere_model(Affine::scale(50));
    const Vec3 from = Vec3(3, 1, 2).normalized();
    const auto contours =
        contour_curves(sphere, LineEye(camera_at(from * 300, Projection::orthographic)));
    ASSERT_FALSE(contours.empty());
    for (const ContourLine& contour : contours)
        for (const Vec3& p : contour.points) EXPECT_NEAR(p.dot(from), 0, 1e-6);
    EXPECT_NEAR(total_length(contours), 100 * std::numbers::pi, 0.05);
}

TEST(ContourCurves, OfACylinderAreTwoOfItsLines) {
    const SurfaceModel cylinder = test::cylinder_model(Affine::scale(20));
    const auto contours =
        contour_curves(cylinder, LineEye(camera_at({400, 300, 0}, Projection::orthographic)));
    ASSERT_EQ(contours.size(), 2u);
    for (const ContourLine& contour : contours) {
        EXPECT_NEAR(contour.length, 40, 1e-6);
        const Vec3 side = contour.points.front();
        EXPECT_NEAR(std::abs(side.x * 0.6 - side.y * 0.8), 20, 1e-6);
        EXPECT_NEAR(side.x * 0.8 + side.y * 0.6, 0, 1e-6);
    }
}

TEST(ContourCurves, AlongSidesOfPatchesAreFoundOnce) {
    const SurfaceModel sphere = test::sphere_model(Affine::scale(50));
    const SurfaceModel cylinder = test::cylinder_model(Affine::scale(20));
    for (const Vec3& from : {Vec3(1, 0, 0), Vec3(0, -1, 0)}) {
        const LineEye eye(camera_at(from * 300, Projection::orthographic));
        EXPECT_NEAR(total_length(contour_curves(sphere, eye)), 100 * std::numbers::pi, 0.05);
        const auto lines = contour_curves(cylinder, eye);
        EXPECT_NEAR(total_length(lines), 80, 1e-6);
        for (const ContourLine& line : lines)
            for (const Vec3& p : line.points) EXPECT_NEAR(p.dot(from), 0, 1e-6);
    }
}

TEST(ContourCurves, OfAPlateSeenEdgeOnAreNone) {
    test::ModelBuilder builder;
    builder.plane({-50, -50, 0}, {100, 0, 0}, {0, 100, 0});
    const LineEye eye(camera_at({400, 0, 0}, Projection::orthographic));
    EXPECT_TRUE(contour_curves(builder.build(), eye).empty());
}

TEST(ContourCurves, AreTheSameForAnyNumberOfThreads) {
    const SurfaceModel torus = test::torus_model(60, 15);
    const LineEye eye(camera_at({300, 100, 200}, Projection::perspective));
    const auto one = contour_curves(torus, eye, 0.01, {.threads = 1});
    const auto three = contour_curves(torus, eye, 0.01, {.threads = 3});
    ASSERT_EQ(one.size(), three.size());
    ASSERT_GE(one.size(), 2u); // outer and inner
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].points, three[i].points);
}

} // namespace
} // namespace keiko
