#include "keiko/scene/stereo.h"

#include "keiko/base/error.h"
#include "keiko/base/units.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>

namespace keiko {
namespace {

using test::OracleRow;
using test::OracleTable;

/// The camera of a row: its picture is W x H mm on the screen at distance D.
Camera camera_of(const OracleRow& row) {
    Camera camera;
    camera.eye = row.vector("in.E");
    camera.target = camera.eye + row.unit("in.F") * row.number("in.D");
    camera.up = row.unit("in.Up");
    camera.vertical_fov =
        radians_to_degrees(2 * std::atan(row.number("in.H") / (2 * row.number("in.D"))));
    camera.width = row.integer("in.nx");
    camera.height = row.integer("in.ny");
    return camera;
}

/// The oracle's pixels are W / nx wide; ours are as wide as high, H / ny.
double oracle_pixels(const OracleRow& row, double x) {
    const double nx = row.number("in.nx");
    const double ours = row.number("in.H") / row.number("in.ny");
    return (x - nx / 2) * ours / (row.number("in.W") / nx) + nx / 2;
}

TEST(Stereo, PointsMeetTheOracle) {
    for (const OracleRow& row : OracleTable("stereo_points")) {
        const Camera camera = camera_of(row);
        const Stereo stereo{.eye_distance = row.number("in.b")};
        const auto [left, right] = stereo_pair(camera, stereo);
        const Vec3 point = row.vector("in.Q");
        const auto in_left = project(left, point), in_right = project(right, point);
        ASSERT_TRUE(in_left && in_right) << row.id();
        EXPECT_NEAR(oracle_pixels(row, in_left->x), row.number("out.px_L"), 1e-9) << row.id();
        EXPECT_NEAR(oracle_pixels(row, in_right->x), row.number("out.px_R"), 1e-9) << row.id();
        EXPECT_NEAR(in_left->y, row.number("out.py_L"), 1e-9) << row.id();
        EXPECT_NEAR(in_right->y, row.number("out.py_R"), 1e-9) << row.id();
        EXPECT_NEAR(stereo_parallax(camera, stereo, row.number("out.z")),
                    row.number("out.parallax"), 1e-9)
            << row.id();
    }
}

TEST(Stereo, LampsInMirrorsMeetTheOracle) {
    for (const OracleRow& row : OracleTable("stereo_mirror")) {
        const Camera camera = camera_of(row);
        const auto [left, right] = stereo_pair(camera, {.eye_distance = row.number("in.b")});
        const auto in_left = project(left, row.vector("out.XL"));
        const auto in_right = project(right, row.vector("out.XR"));
        ASSERT_TRUE(in_left && in_right) << row.id();
        EXPECT_NEAR(oracle_pixels(row, in_left->x), row.number("out.px_L"), 1e-7) << row.id();
        EXPECT_NEAR(oracle_pixels(row, in_right->x), row.number("out.px_R"), 1e-7) << row.id();
        const double mm = row.number("in.H") / row.number("in.ny");
        EXPECT_NEAR((in_left->y - in_right->y) * mm, row.number("out.dy"), 1e-7) << row.id();
    }
}

TEST(Stereo, BothEyesSeeTheSamePartOfTheScreen) {
    Camera camera;
    camera.eye = {-2500, 1300, 900}, camera.target = {150, -40, 420};
    const Stereo stereo{.eye_distance = 70, .screen_distance = 1234};
    const auto [left, right] = stereo_pair(camera, stereo);
    for (const Vec2& pixel : {Vec2(0, 0), Vec2(960, 540), Vec2(13.5, 400)}) {
        const auto on_screen = [&](const Camera& eye) {
            const Ray ray = eye.ray(pixel.x, pixel.y);
            return ray.at(1234 / ray.direction.dot(camera.axes().forward));
        };
        EXPECT_LT((on_screen(left) - on_screen(camera)).length(), 1e-9);
        EXPECT_LT((on_screen(right) - on_screen(camera)).length(), 1e-9);
    }
    EXPECT_NEAR((right.eye - left.eye).length(), 70, 1e-9);
    EXPECT_NEAR((right.eye - left.eye).dot(camera.axes().right), 70, 1e-9);
}

TEST(Stereo, TheScreenStandsAtTheTargetUnlessStated) {
    const Camera camera;
    const double distance = (camera.target - camera.eye).length();
    EXPECT_NEAR(stereo_parallax(camera, {}, distance), 0, 1e-12);
    EXPECT_NEAR(stereo_parallax(camera, {.screen_distance = 500}, 500), 0, 1e-12);
}

TEST(Stereo, TheLargestParallaxIsThatOfTheNearestOrFarthestPoint) {
    Camera camera;
    camera.eye = {-1000, 0, 0}, camera.target = {0, 0, 0};
    const Stereo stereo{.eye_distance = 60};
    const auto of_cube = [&](double half) {
        return largest_parallax(camera, stereo, Box3{Vec3(-half), Vec3(half)});
    };
    EXPECT_NEAR(of_cube(500), 60 * (1 - 1000 / 500.0), 1e-9);
    EXPECT_NEAR(largest_parallax(camera, stereo, Box3{Vec3(0), Vec3(3000)}), 60 * 0.75, 1e-9);
    EXPECT_EQ(of_cube(1000), -HUGE_VAL);
}

TEST(Stereo, CamerasWithoutAnEyeAndDistancesOfNothingAreRefused) {
    Camera parallel;
    parallel.projection = Projection::orthographic, parallel.orthographic_height = 1000;
    EXPECT_THROW(stereo_pair(parallel, {}), FieldError);
    EXPECT_THROW(stereo_pair({}, {.eye_distance = 0}), FieldError);
    EXPECT_THROW(stereo_pair({}, {.screen_distance = -1}), FieldError);
}

} // namespace
} // namespace keiko
