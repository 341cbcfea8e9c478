#include "keiko/scene/animation.h"

#include "keiko/base/error.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/scene/scene_spec.h"

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
    EXPECT_FALSE(animation_fault(own, own.animations.front()));
    return at_frame(own, frame);
}

std::string fault(const std::string& target, std::vector<double> value) {
    SceneSpec own = scene();
    return animation_fault(own, {target, {{0, std::move(value)}}}).value().what;
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
    EXPECT_EQ(body.models[0].transform.affine().point(Vec3(1)), Vec3(8, 9, 10));
    const SceneSpec turned =
        animated("model.0.transform.rotate", {{0, {0, 0, 1, 0}}, {4, {0, 0, 1, 180}}}, 2);
    const Vec3 end = turned.models[0].transform.affine().point(Vec3(1, 0, 0));
    EXPECT_NEAR((end - Vec3(0, 1, 0)).length(), 0, 1e-15);
    EXPECT_EQ(
        animated("model.0.transform.scale", {{0, {1}}, {2, {3}}}, 1).models[0].transform.scale, 2);
}

TEST(Animation, WhatCannotMoveIsNamed) {
    EXPECT_EQ(fault("spotlight.2.aim", {0, 0, 0}),
              "the scene has no 'spotlight.2.aim' that moves (did you mean 'spotlight.0'?)");
    EXPECT_EQ(fault("model.0.transform.rotation", {0, 0, 1, 0}),
              "the scene has no 'model.0.transform.rotation' that moves (did you mean "
              "'transform.rotate'?)");
    EXPECT_EQ(fault("camara.eye", {0, 0, 0}),
              "the scene has no 'camara.eye' that moves (did you mean 'camera'?)");
    EXPECT_EQ(fault("spotlight.0.colour", {1}), "the scene has no 'spotlight.0.colour' that moves");
    EXPECT_EQ(fault("camera", {1}), "the scene has no 'camera' that moves");
    EXPECT_EQ(fault("camera.eye", {1}), "each value of 'camera.eye' needs 3 numbers");
    EXPECT_EQ(fault("spotlight.0.spin", {1, 2}), "each value of 'spotlight.0.spin' needs 1 number");
    EXPECT_EQ(fault("model.0.transform.scale", {0}),
              "a value of 'model.0.transform.scale' is out of range");
    EXPECT_EQ(fault("camera.eye", {0, 0, 1e300}), "a value of 'camera.eye' is out of range");
    EXPECT_EQ(fault("fog.extinction", {1e300}), "a value of 'fog.extinction' is out of range");
    EXPECT_EQ(fault("fog.extinction", {-1}), "a value of 'fog.extinction' is out of range");
    EXPECT_EQ(fault("model.0.transform.rotate", {0, 0, 0, 90}),
              "a value of 'model.0.transform.rotate' has no direction");
}

TEST(Animation, ADirectionDoesNotTurnIntoItsOpposite) {
    SceneSpec own = scene();
    const Animation over{"model.0.transform.rotate", {{0, {0, 0, 1, 0}}, {9, {0, 0, -2, 90}}}};
    const auto fault = animation_fault(own, over);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->key, "keys");
    EXPECT_EQ(
        fault->what,
        "between two keys of 'model.0.transform.rotate' the direction turns into its opposite");
}

TEST(Animation, AFrameWithoutAPictureIsRefused) {
    SceneSpec own = scene();
    own.animations = {{"sun.direction", {{0, {1, 0, 0}}, {2, {-1, 0, 0}}}}};
    EXPECT_THROW(at_frame(own, 1), Error);
    EXPECT_NO_THROW(at_frame(own, 0.5));
}

/// An axis that swings through the direction of phi = 0 does not flip the pattern.
TEST(Animation, CarriesThePatternAlongWithTheAxis) {
    SceneSpec own = scene();
    auto& light = std::get<Spotlight>(own.rig->sources[0]);
    light.reference = Vec3(1, 0, 0);
    own.animations = {{"spotlight.0.aim", {{0, {-1, 0, -1}}, {10, {3, 0, -1}}, {20, {3, 4, -1}}}}};
    const auto frame_at = [&](double frame) {
        const SceneSpec moved = at_frame(own, frame);
        const auto& lamp = std::get<Spotlight>(moved.rig->sources[0]);
        return beam_frame(lamp.aim - lamp.position, lamp.reference);
    };
    BeamFrame before = frame_at(0);
    EXPECT_GT(before.across.x, 0);
    for (int i = 1; i <= 200; ++i) {
        const BeamFrame here = frame_at(0.1 * i);
        EXPECT_LT((here.across - before.across).length(), 0.15) << i;
        // Parallel: what turns is the axis alone.
        EXPECT_NEAR((here.across - before.across).dot(before.up), 0, 2e-3) << i;
        before = here;
    }
    own.animations.push_back({"spotlight.0.reference", {{0, {0, 1, 0}}}});
    EXPECT_NEAR(frame_at(5).across.y, 1, 1e-12);
}

TEST(CarriedReference, TurnsBySolidAngleOfThePathAround) {
    // Around an eighth of the sphere, whose solid angle is a quarter of a half turn.
    const std::vector<Vec3> ways{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    const Vec3 back = carried_reference(Vec3(0, 1, 0), ways);
    EXPECT_NEAR((back - Vec3(0, 0, 1)).length(), 0, 1e-15);
}
