#include "keiko/light/luminance/fresnel.h"
#include "keiko/visibility/query/occluders.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace keiko {
namespace {

using test::dome;
using test::flat_plate;
using test::Stage;

double green(const Film& film, int x, int y) {
    return static_cast<double>(film.color.pixel(x, y)[1]);
}

SkyLight overcast() {
    SkyLight sky{SkyModel::overcast, Rgb(900, 600, 300)};
    sky.ground = Rgb(90);
    return sky;
}

/// Sky and ground beside the body by elevation; the horizon in the middle of a pixel is their mean.
TEST(SkyPicture, CameraSeesSkyAndGroundBesideTheBody) {
    Stage stage(flat_plate());
    stage.rig.sources = {overcast()};
    stage.camera.target = stage.camera.eye + Vec3(0, 1000, 0);
    const Film film = stage.render({.aovs = {}, .edge_samples = 1});
    const int x = stage.camera.width / 2, middle = stage.camera.height / 2;
    const PreparedCamera camera(stage.camera);
    for (int y = 0; y < middle; y += 5) {
        const std::array at{Vec2(x + 0.5, y + 0.5)};
        const double sine = camera.rays(at).front().direction.normalized().z;
        EXPECT_NEAR(green(film, x, y), 200 * (1 + 2 * sine), 0.1) << y;
    }
    ASSERT_EQ(stage.camera.height % 2, 0);
    EXPECT_NEAR(green(film, x, middle), 90, 1e-4);
    Stage odd = stage;
    ++odd.camera.height;
    const Film between = odd.render({.aovs = {}, .edge_samples = 1});
    EXPECT_NEAR(green(between, x, middle), (200 + 90) / 2.0, 0.5);
}

TEST(SkyPicture, MirrorShowsTheSkyTimesFresnels) {
    Stage stage(flat_plate());
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    stage.rig.sources = {overcast()};
    stage.rig.ambient = Rgb(1e5); // behind the sky
    const Film film = stage.render({.aovs = {}, .edge_samples = 1});
    const double cosine = 1500 / std::hypot(1500, 3000); // of the ray to the plate's middle
    const double seen = 200 * (1 + 2 * cosine) * fresnel_dielectric(cosine, 1.5);
    EXPECT_NEAR(green(film, stage.camera.width / 2, stage.camera.height / 2), seen, 0.02 * seen);
}

TEST(SkyPicture, LevelPlateHasTheLightOfTheWholeSky) {
    Stage stage(flat_plate(), 1); // no coat
    stage.rig.sources = {overcast()};
    const double even = 600 * 7.0 / 9 * 0.2;
    EXPECT_NEAR(green(stage.render(), 48, 27), even, 1e-3 * even);
}

/// A wall without end that stands on the plate and hides what is beyond: of a uniform sky the part
/// (1 - sin b) / 2, where its top is b from the vertical.
TEST(SkyPicture, WallHidesTheSkyBeyond) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    builder.plane({-5e6, 0.5, 0}, {1e7, 0, 0}, {0, 0, 2000});
    Stage stage(builder.build(), 1);
    stage.rig.sources = {SkyLight{SkyModel::uniform, Rgb(100)}};
    const Occluders occluders(stage.model, stage.tracer);
    const Film film = render({.tracer = stage.tracer,
                              .materials = stage.materials,
                              .rig = stage.rig,
                              .background = Rgb(7),
                              .occluders = &occluders},
                             stage.camera, {}, {});
    const Ray ray = PreparedCamera(stage.camera).rays(std::array{Vec2(48.5, 28.5)}).front();
    const double away = 0.5 - ray.at(-ray.origin.z / ray.direction.z).y;
    EXPECT_NEAR(green(film, 48, 28), 10 * (1 + away / std::hypot(away, 2000)), 0.03);
}

TEST(SkyPicture, WindowShowsTheSkyAndWallsTheBackground) {
    Stage stage(flat_plate());
    stage.camera.target = stage.camera.eye + Vec3(0, 1000, 0);
    SkyLight sky = overcast();
    const Vec3 eye = stage.camera.eye + Vec3(0, 2000, 0);
    sky.windows = {{{eye + Vec3(-200, 0, 50), eye + Vec3(200, 0, 50), eye + Vec3(200, 0, 300),
                     eye + Vec3(-200, 0, 300)}}};
    stage.rig.sources = {sky};
    const Film film = stage.render({.aovs = {}, .edge_samples = 1});
    const int x = stage.camera.width / 2;
    EXPECT_EQ(green(film, x, stage.camera.height - 3), 7); // the background of a stage
    int bright = 0;
    for (int y = 0; y < stage.camera.height; ++y) bright += green(film, x, y) > 200;
    EXPECT_GT(bright, 3);
    EXPECT_LT(bright, stage.camera.height / 2);
}

TEST(SkyPicture, SameBytesForAnyNumberOfThreads) {
    Stage stage(dome());
    SkyLight clear{SkyModel::clear, Rgb(3000)};
    clear.sun = Vec3(-0.5, -0.6, 0.5).normalized();
    stage.rig.sources = {clear};
    EXPECT_EQ(stage.render({}, 1).color.values, stage.render({}, 3).color.values);
}

} // namespace
} // namespace keiko
