#include "keiko/spec/animation.h"

#include "keiko/base/error.h"
#include "keiko/spec/scene_spec.h"

#include <gtest/gtest.h>

using namespace keiko;

namespace {

SceneSpec scene() {
    SceneSpec scene;
    scene.models.emplace_back();
    scene.camera = Camera();
    scene.rig = LightRig{.name = "",
                         .sources = {Spotlight(), CPlane(), Luminaire(), Spotlight(), Sun()},
                         .ambient = Rgb(0),
                         .medium = Medium{}};
    return scene;
}

SceneSpec animated(const std::string& target, std::vector<KeyFrame> keys, double frame) {
    SceneSpec own = scene();
    own.animations = {{target, std::move(keys)}};
    EXPECT_EQ(animation_fault(own, own.animations.front()), "");
    return at_frame(own, frame);
}

std::string fault(const std::string& target, std::vector<double> value) {
    SceneSpec own = scene();
    return animation_fault(own, {target, {{0, std::move(value)}}});
}

} // namespace

TEST(Animation, MovesStraightBetweenKeysAndRestsBeyondThem) {
    const Animation move{"camera.eye", {{10, {0, 0, 0}}, {20, {100, 50, 0}}, {30, {100, 60, 10}}}};
    EXPECT_EQ(move.at(-5), (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(move.at(10), (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(move.at(15), (std::vector<double>{50, 25, 0}));
    EXPECT_EQ(move.at(20), (std::vector<double>{100, 50, 0}));
    EXPECT_EQ(move.at(25), (std::vector<double>{100, 55, 5}));
    EXPECT_EQ(move.at(99), (std::vector<double>{100, 60, 10}));
}

TEST(Animation, CountsLampsOfAKind) {
    const SceneSpec moved = animated("spotlight.1.spin", {{0, {0}}, {4, {40}}}, 3);
    EXPECT_EQ(std::get<Spotlight>(moved.rig->sources[3]).spin, 30);
    EXPECT_EQ(std::get<Spotlight>(moved.rig->sources[0]).spin, 0);
    const SceneSpec lamp = animated("luminaire.0.position", {{0, {1, 2, 3}}}, 0);
    EXPECT_EQ(std::get<Luminaire>(lamp.rig->sources[2]).position, Vec3(1, 2, 3));
}

TEST(Animation, ReachesEyeBodySunAndFog) {
    EXPECT_EQ(animated("camera.target", {{0, {1, 2, 3}}}, 0).camera->target, Vec3(1, 2, 3));
    EXPECT_EQ(animated("sun.direction", {{0, {1, 0, -2}}}, 0).rig->sources.size(), 5u);
    EXPECT_EQ(animated("fog.extinction", {{0, {0}}, {2, {0.4}}}, 1).rig->medium->extinction,
              Rgb(0.2));
    const SceneSpec body = animated("model.0.transform.translate", {{0, {7, 8, 9}}}, 0);
    EXPECT_EQ(body.models[0].transform.point(Vec3(1)), Vec3(8, 9, 10));
}

TEST(Animation, WhatCannotMoveIsNamed) {
    EXPECT_EQ(fault("spotlight.2.aim", {0, 0, 0}), "the scene has no 'spotlight.2.aim' that moves");
    EXPECT_EQ(fault("spotlight.0.colour", {1}), "the scene has no 'spotlight.0.colour' that moves");
    EXPECT_EQ(fault("camera", {1}), "the scene has no 'camera' that moves");
    EXPECT_EQ(fault("camera.eye", {1}), "each value of 'camera.eye' needs 3 numbers");
    EXPECT_EQ(fault("spotlight.0.spin", {1, 2}), "each value of 'spotlight.0.spin' needs 1 number");
    EXPECT_EQ(fault("fog.extinction", {-1}), "a value of 'fog.extinction' is out of range");
}

TEST(Animation, AFrameWithoutAPictureIsRefused) {
    SceneSpec own = scene();
    own.animations = {{"sun.direction", {{0, {1, 0, 0}}, {2, {-1, 0, 0}}}}};
    EXPECT_THROW(at_frame(own, 1), Error);
    EXPECT_NO_THROW(at_frame(own, 0.5));
}
