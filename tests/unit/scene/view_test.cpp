#include "keiko/scene/view.h"

#include "keiko/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

const Box3 car{Vec3(-2300, -900, 0), Vec3(2300, 900, 1450)};

std::vector<Vec3> corners(const Box3& box) {
    std::vector<Vec3> points;
    for (const double x : {box.lower.x, box.upper.x})
        for (const double y : {box.lower.y, box.upper.y})
            for (const double z : {box.lower.z, box.upper.z}) points.emplace_back(x, y, z);
    return points;
}

/// Bounds of the box in the picture, as shares of width and height.
Box2 framed(const Camera& camera, const Box3& box) {
    Box2 seen;
    for (const Vec3& corner : corners(box))
        seen.extend(project(camera, corner).value() / Vec2(camera.width, camera.height));
    return seen;
}

TEST(View, EveryNamedViewFillsThePictureUpToItsMargin) {
    for (const std::string& name : view_names()) {
        const bool standing = name.starts_with("standing-");
        for (const Box3& box : {car, Box3{Vec3(10, 20, 30), Vec3(310, 220, 31)},
                                Box3{Vec3(-2e4, -3e3, -5e3), Vec3(1.8e4, 3e3, 2e3)}}) {
            const Box2 seen = framed(frame_view(name, box), box);
            EXPECT_GE(seen.lower.x, 0.04 - 1e-3) << name;
            EXPECT_LE(seen.upper.x, 0.96 + 1e-3) << name;
            EXPECT_GE(seen.lower.y, 0.04 - 1e-3) << name;
            EXPECT_LE(seen.upper.y, 0.96 + 1e-3) << name;
            EXPECT_NEAR(std::max(seen.extent().x, seen.extent().y), 0.92, standing ? 2e-3 : 1e-9)
                << name;
        }
    }
}

TEST(View, ViewsLookFromWhereTheirNameSays) {
    const auto eye = [](std::string_view name) {
        const Camera camera = frame_view(name, car);
        return (camera.eye - camera.target).normalized();
    };
    EXPECT_NEAR(eye("front").x, -1, 1e-12);
    EXPECT_NEAR(eye("rear").x, 1, 1e-12);
    EXPECT_NEAR(eye("left").y, -1, 1e-12);
    EXPECT_NEAR(eye("right").y, 1, 1e-12);
    EXPECT_NEAR(eye("top").z, 1, 1e-12);
    EXPECT_NEAR(eye("bottom").z, -1, 1e-12);
    const Vec3 quarter = eye("three-quarter-front-right");
    EXPECT_LT(quarter.x, -0.5);
    EXPECT_GT(quarter.y, 0.5);
    EXPECT_NEAR(quarter.z, std::sin(15 * 3.14159265358979 / 180), 1e-9);
    EXPECT_EQ(frame_view("three-quarter-rear", car), frame_view("three-quarter-rear-left", car));
    EXPECT_GT(eye("high-rear").z, 0.6);
}

TEST(View, TopShowsTheFrontOfTheCarToTheLeft) {
    const Camera camera = frame_view("top", car);
    const Vec2 front = project(camera, {-2300, 0, 0}).value();
    const Vec2 right_side = project(camera, {0, 900, 0}).value();
    EXPECT_LT(front.x, camera.width * 0.2);
    EXPECT_LT(right_side.y, camera.height * 0.5);
}

TEST(View, AStandingEyeIsAtWalkingDistance) {
    for (const std::string name :
         {"standing-front", "standing-left", "standing-three-quarter-rear"})
        for (const Box3& box : {car, Box3{Vec3(0, 0, 200), Vec3(300, 400, 260)}}) {
            const Camera camera = frame_view(name, box);
            const Vec3 away = camera.eye - box.center();
            const double horizontal = std::hypot(away.x, away.y);
            const double reach =
                (std::abs(away.x) * box.extent().x + std::abs(away.y) * box.extent().y) /
                (2 * horizontal);
            EXPECT_GE(horizontal - reach, 3000 - 1e-6) << name;
            EXPECT_LE(horizontal - reach, 5000 + 1e-6) << name;
        }
}

TEST(View, AStandingEyeIsAtEyeHeight) {
    const auto height = [](double lowest, const Framing& framing = {}) {
        const Box3 panel{Vec3(0, 0, lowest), Vec3(300, 400, lowest + 60)};
        return frame_view("standing-left", panel, framing).eye.z;
    };
    EXPECT_NEAR(height(0), 1650, 1e-9);
    EXPECT_NEAR(height(815), 1650, 1e-9) << "a panel in the coordinates of its vehicle";
    EXPECT_NEAR(height(-300), 1350, 1e-9);
    EXPECT_NEAR(height(2000), 3650, 1e-9) << "above the eye of somebody on z = 0";
    EXPECT_NEAR(height(815, {.ground = -150}), 1500, 1e-9);
}

TEST(View, FramingFollowsTheAspectOfThePicture) {
    const Camera tall = frame_view("left", car, {.width = 300, .height = 900});
    EXPECT_EQ(tall.width, 300);
    const Box2 seen = framed(tall, car);
    EXPECT_NEAR(seen.extent().x, 0.92, 1e-9);
    EXPECT_LT(seen.extent().y, 0.2);
}

TEST(View, APointIsFramedAndAnEmptyBoxIsRefused) {
    const Camera camera = frame_view("front", {Vec3(5), Vec3(5)});
    EXPECT_TRUE(is_finite(camera.ray(1, 1).direction));
    EXPECT_GT((camera.eye - camera.target).length(), 0.5);
    EXPECT_THROW(frame_view("front", {}), Error);
    EXPECT_THROW(frame_view("standing-front", {}), Error);
}

TEST(View, AnUnknownNameListsTheKnownOnes) {
    try {
        frame_view("three-quater-front", car);
        FAIL() << "no error";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("did you mean 'three-quarter-front'?"), std::string::npos) << text;
        for (const std::string& name : view_names())
            EXPECT_NE(text.find(name), std::string::npos) << name;
    }
    EXPECT_THROW(frame_view("high-top", car), Error);
}

} // namespace
} // namespace keiko
