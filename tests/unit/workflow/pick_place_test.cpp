#include "keiko/api/scene.h"
#include "keiko/api/view.h"
#include "keiko/geometry/bezier/differential_geometry.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr int side = 16; // pixels of a picture

Scene scene_of(const std::string& model, const std::string& ground = "") {
    const test::TemporaryFolder folder;
    const auto file =
        folder.file("scene.toml", "format = \"keiko-scene/1\"\n" + ground + "[[model]]\nfile = \"" +
                                      test::repository("surfaces/" + model).string() + "\"\n");
    const std::filesystem::path inputs[] = {file};
    return open_scene(inputs);
}

Camera camera_at(const Vec3& eye, const Vec3& target = Vec3(0)) {
    Camera camera;
    camera.eye = eye, camera.target = target;
    camera.width = camera.height = side;
    return camera;
}

std::optional<PickedPlace> picked(const Scene& scene, const Camera& camera, const Vec2& pixel) {
    return pick_place(scene, scene.seen(), camera, pixel);
}

bool holds(const Interval& range, double value) {
    return range.low <= value && value <= range.high;
}

} // namespace

TEST(PickPlace, BoundsHoldThePlaceAndTheCurvatureOfASphere) {
    const Scene scene = scene_of("rational-sphere.step");
    const Camera camera = camera_at({-700, -300, 400});
    constexpr double radius = 100, made = 1.1e-11; // mm: error of the file
    int found = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto place = picked(scene, camera, {x + 0.25, y + 0.75});
            if (!place) continue;
            EXPECT_NEAR(place->place.length(), radius, place->bound + made);
            EXPECT_GT(place->normal.dot(camera.eye - place->place), 0);
            // Crowned as the eye sees it.
            const double exact = -1 / radius, slack = 1e-12;
            EXPECT_TRUE(holds(place->k1.padded(slack), exact)) << place->k1.low;
            EXPECT_TRUE(holds(place->k2.padded(slack), exact)) << place->k2.high;
            EXPECT_LT(place->k1.high - place->k2.low, 1e-3 / radius);
            ++found;
        }
    EXPECT_GT(found, 20);
}

TEST(PickPlace, RangesHoldTheCurvaturesOfTheHitFromEitherSide) {
    const Scene scene = scene_of("hood.step");
    const Vec3 middle(560, 0, 720);
    for (const Vec3& eye : {Vec3(-2000, -1500, 1800), Vec3(500, 300, -1500)}) {
        const Camera camera = camera_at(eye, middle);
        int found = 0, narrow = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Vec2 pixel(x + 0.5, y + 0.5);
                const auto place = picked(scene, camera, pixel);
                if (!place) continue;
                const auto hit = scene.tracer.nearest(camera.ray(pixel.x, pixel.y));
                ASSERT_TRUE(hit);
                EXPECT_EQ(place->face, scene.model.faces[hit->face].id);
                const PrincipalCurvatures k =
                    principal_curvatures(derivatives_of(*hit), place->normal);
                const double slack = 1e-9 * (std::abs(k.k1) + std::abs(k.k2));
                EXPECT_TRUE(holds(place->k1.padded(slack), k.k1)) << k.k1;
                EXPECT_TRUE(holds(place->k2.padded(slack), k.k2)) << k.k2;
                // Wide only where the curvature changes within a tenth of a millimetre.
                const double width = place->k1.high - place->k1.low;
                EXPECT_LT(width, 1e-4);
                narrow += width < 5e-7;
                ++found;
            }
        EXPECT_GT(found, 20);
        EXPECT_GT(narrow, found / 2);
    }
}

TEST(PickPlace, TheGroundIsFlatAndNothingIsNoPlace) {
    const Scene scene = scene_of("rational-sphere.step", "ground = { z = -150 }\n");
    const auto ground = picked(scene, camera_at({0, -900, 600}), {8, 15.5});
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->face, 0u);
    EXPECT_NEAR(ground->place.z, -150, ground->bound + 1e-12);
    EXPECT_EQ(ground->k1.magnitude() + ground->k2.magnitude(), 0);
    EXPECT_FALSE(picked(scene, camera_at({0, -900, 600}, {0, 0, 2000}), {8, 0.5}));
    EXPECT_EQ(pick_json(std::nullopt), "{\n \"format\": \"keiko-pick/1\",\n \"picked\": null\n}\n");
}

TEST(PickPlace, AFaceThatIsHiddenIsNotPicked) {
    const Scene scene = scene_of("hood.step");
    const Camera camera = camera_at({-2000, -1500, 1800}, {560, 0, 720});
    const auto seen = picked(scene, camera, {8, 8});
    ASSERT_TRUE(seen);
    const auto behind = pick_place(scene, seen_without(scene, {&seen->face, 1}), camera, {8, 8});
    EXPECT_TRUE(!behind || behind->face != seen->face);
}

} // namespace keiko
