#include "keiko/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

Camera perspective_camera() {
    Camera camera;
    camera.eye = {-2500, 1300, 900};
    camera.target = {150, -40, 420};
    camera.up = {0.1, -0.2, 1};
    camera.vertical_fov = 35;
    camera.width = 48;
    camera.height = 30;
    return camera;
}

Camera orthographic_camera() {
    Camera camera = perspective_camera();
    camera.projection = Projection::orthographic;
    camera.orthographic_height = 1200;
    return camera;
}

TEST(Camera, RayThroughTheMiddleHitsTheTarget) {
    const Camera camera = perspective_camera();
    const Ray ray = camera.ray(24, 15);
    EXPECT_NEAR(ray.direction.length(), 1, 1e-15);
    EXPECT_LT((ray.at((camera.target - camera.eye).length()) - camera.target).length(), 1e-9);
}

TEST(Camera, RowsRunDownwardsAndColumnsToTheRight) {
    Camera camera;
    camera.eye = {-4000, 0, 0}; // from the front: the car's right, +y, is to the left
    camera.target = {0, 0, 0};
    EXPECT_GT(camera.ray(480, 0).direction.z, 0);
    EXPECT_LT(camera.ray(480, 540).direction.z, 0);
    EXPECT_GT(camera.ray(0, 270).direction.y, 0);
    EXPECT_LT(camera.ray(960, 270).direction.y, 0);
}

TEST(Camera, FieldOfViewSpansThePictureHeight) {
    const Camera camera = perspective_camera();
    const double angle = angle_between(camera.ray(24, 0).direction, camera.ray(24, 30).direction);
    EXPECT_NEAR(angle * 180 / std::numbers::pi, 35, 1e-12);
}

TEST(Camera, RaysSideBySideHaveTheBitsOfEach) {
    for (const Camera& camera : {perspective_camera(), orthographic_camera()}) {
        const PreparedCamera prepared(camera);
        for (std::size_t count = 0; count < 20; ++count) {
            std::vector<Vec2> points;
            for (std::size_t i = 0; i < count; ++i)
                points.emplace_back(-3.5 + 2.7 * static_cast<double>(i),
                                    31.5 - 1.9 * static_cast<double>(i));
            const Rays rays = prepared.rays(points);
            ASSERT_EQ(rays.size(), count);
            for (std::size_t i = 0; i < count; ++i) {
                const Ray ray = prepared.ray(points[i].x, points[i].y);
                const RayDifferentials &a = *rays[i].differentials, &b = *ray.differentials;
                EXPECT_EQ(rays[i].origin, ray.origin);
                EXPECT_EQ(rays[i].direction, ray.direction);
                EXPECT_EQ(rays[i].t_max, ray.t_max);
                EXPECT_EQ(a.origin_dx, b.origin_dx);
                EXPECT_EQ(a.origin_dy, b.origin_dy);
                EXPECT_EQ(a.direction_dx, b.direction_dx);
                EXPECT_EQ(a.direction_dy, b.direction_dy);
            }
        }
    }
}

TEST(Camera, OrthographicRaysAreParallelAndSpanTheHeight) {
    const Camera camera = orthographic_camera();
    const Ray top = camera.ray(3, 0), bottom = camera.ray(3, 30);
    EXPECT_EQ(top.direction, bottom.direction);
    EXPECT_NEAR((top.origin - bottom.origin).length(), 1200, 1e-9);
    EXPECT_NEAR((top.origin - bottom.origin).dot(top.direction), 0, 1e-9);
    EXPECT_EQ(camera.pixel_solid_angle(0, 0), 1);
}

TEST(Camera, DifferentialsAreTheDerivativesOfTheRay) {
    constexpr double h = 1e-4;
    for (const Camera& camera : {perspective_camera(), orthographic_camera()})
        for (const Vec2& at : {Vec2(1.5, 2.5), Vec2(40.2, 28.9)}) {
            const RayDifferentials d = camera.ray(at.x, at.y).differentials.value();
            const Ray right = camera.ray(at.x + h, at.y), left = camera.ray(at.x - h, at.y);
            const Ray below = camera.ray(at.x, at.y + h), above = camera.ray(at.x, at.y - h);
            const auto slope = [](const Vec3& a, const Vec3& b) { return (a - b) / (2 * h); };
            EXPECT_LT((slope(right.direction, left.direction) - d.direction_dx).length(), 1e-10);
            EXPECT_LT((slope(below.direction, above.direction) - d.direction_dy).length(), 1e-10);
            EXPECT_LT((slope(right.origin, left.origin) - d.origin_dx).length(), 1e-7);
            EXPECT_LT((slope(below.origin, above.origin) - d.origin_dy).length(), 1e-7);
        }
}

/// Solid angle of a rectangle seen from the point above one of its corners at distance 1.
double corner_solid_angle(double a, double b) {
    return std::atan(a * b / std::sqrt(1 + a * a + b * b));
}

TEST(Camera, PixelSolidAnglesAddUpToThePicture) {
    Camera camera = perspective_camera();
    const double half = std::tan(35.0 / 2 * std::numbers::pi / 180);
    const double whole = 4 * corner_solid_angle(half * 48 / 30, half);
    double coarse = 0;
    for (int fineness : {1, 4}) {
        camera.width = 48 * fineness;
        camera.height = 30 * fineness;
        double sum = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x)
                sum += camera.pixel_solid_angle(x + 0.5, y + 0.5);
        EXPECT_NEAR(sum / whole, 1, 3e-4 / (fineness * fineness));
        // The midpoint rule: four times finer, sixteen times nearer.
        if (fineness > 1) {
            EXPECT_NEAR((coarse - whole) / (sum - whole), 16, 0.5);
        }
        coarse = sum;
    }
}

TEST(Camera, ProjectIsTheInverseOfRay) {
    for (const Camera& camera : {perspective_camera(), orthographic_camera()})
        for (const Vec2& at : {Vec2(0.5, 0.5), Vec2(31.25, 7), Vec2(-9, 64)}) {
            const Vec2 back = project(camera, camera.ray(at.x, at.y).at(1234)).value();
            EXPECT_LT((back - at).length(), 1e-10);
        }
}

TEST(Camera, NothingProjectsFromBehindTheEye) {
    const Camera camera = perspective_camera();
    const Vec3 view = camera.target - camera.eye;
    EXPECT_FALSE(project(camera, camera.eye - view));
    EXPECT_FALSE(project(camera, camera.eye));
    EXPECT_TRUE(project(orthographic_camera(), camera.eye - view));
}

TEST(Camera, AnUpAlongTheViewIsReplaced) {
    Camera camera;
    camera.eye = {0, 0, 5000};
    camera.target = {0, 0, 0};
    const CameraAxes axes = camera.axes();
    EXPECT_EQ(axes.right, Vec3(1, 0, 0));
    EXPECT_EQ(axes.up, Vec3(0, 1, 0));
    EXPECT_TRUE(is_finite(camera.ray(0.5, 0.5).direction));
}

} // namespace
} // namespace keiko
