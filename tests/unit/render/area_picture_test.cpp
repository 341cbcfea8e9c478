#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/light/rig/rig_areas.h"
#include "keiko/maps/scene_maps.h"
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

/// A panel 1.2 km wide at a height of 2 m, which shines down: all of the sky but its rim.
const PolygonLight sky{{{-6e5, -6e5, 2000}, {-6e5, 6e5, 2000}, {6e5, 6e5, 2000}, {6e5, -6e5, 2000}},
                       Rgb(100)};
/// An L over the plate, where the mirror image of the eye looks.
const PolygonLight angle{{{-900, 700, 2000},
                          {-900, 4000, 2000},
                          {200, 4000, 2000},
                          {200, 2500, 2000},
                          {900, 2500, 2000},
                          {900, 700, 2000}},
                         Rgb(900, 600, 300)};
const SphereLight globe{{300, 1700, 1500}, 450, Rgb(100, 500, 900)};

double green(const Film& film, int x, int y) {
    return static_cast<double>(film.color.pixel(x, y)[1]);
}

/// Largest difference to the mean over n x n rays a pixel, and the share of pixels that differ by
/// more than `small`.
struct Difference {
    double largest = 0, many = 0;
};

Difference to_supersampling(const Stage& stage, double small) {
    const Film one = stage.render({.aovs = {}, .edge_samples = 1});
    constexpr int n = 8;
    Stage fine = stage;
    fine.camera.width *= n, fine.camera.height *= n;
    const Film many = fine.render({.aovs = {}, .edge_samples = 1});
    Difference difference;
    for (int y = 0; y < stage.camera.height; ++y)
        for (int x = 0; x < stage.camera.width; ++x) {
            double mean = 0;
            bool whole = true;
            for (int i = 0; i < n * n; ++i) {
                mean += green(many, x * n + i % n, y * n + i / n) / (n * n);
                whole = whole && many.alpha.pixel(x * n + i % n, y * n + i / n)[0] == 1;
            }
            if (!whole) continue; // at the plate's border
            const double off = std::abs(green(one, x, y) - mean);
            difference.largest = std::max(difference.largest, off);
            difference.many += off > small;
        }
    difference.many /= stage.camera.width * stage.camera.height;
    return difference;
}

/// Fresnel's share of a sky's luminance, and nothing else, on a black plate under a coat.
TEST(AreaPicture, MirrorShowsTheLuminanceOfAPanelTimesFresnels) {
    Stage stage(flat_plate());
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    stage.rig.sources = {sky};
    const Film film = stage.render();
    const double cosine = 1500 / std::hypot(1500, 3000); // of the ray to the plate's middle
    EXPECT_NEAR(green(film, 48, 27), 100 * fresnel_dielectric(cosine, 1.5), 0.3);
}

TEST(AreaPicture, PlateWithoutACoatHasTheLightOfTheWholeSky) {
    Stage stage(flat_plate(), 1);
    stage.rig.sources = {sky};
    EXPECT_NEAR(green(stage.render(), 48, 27), 0.2 * 100, 1e-3);
}

TEST(AreaPicture, MirroredFootprintsAgreeWithSupersampling) {
    Stage stage(flat_plate(), 30); // a mirror
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    stage.rig.sources = {angle};
    const Difference panel = to_supersampling(stage, 6);
    EXPECT_LT(panel.largest, 12); // 2 % of its luminance
    EXPECT_LT(panel.many, 0.01);
    stage.rig.sources = {globe};
    const Difference sphere = to_supersampling(stage, 5);
    EXPECT_LT(sphere.largest, 10);
    EXPECT_LT(sphere.many, 0.01);
}

TEST(AreaPicture, MirroredCurvedLightsAgreeWithSupersampling) {
    Stage stage(flat_plate(), 30);
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    const Rgb color(100, 500, 900);
    const std::array<LightSource, 4> lights{
        EllipsoidLight{{300, 1700, 1500}, {600, 0, 200}, {0, 300, 0}, {-50, 0, 250}, color},
        DiscLight{{0, 2000, 1500}, Vec3(0.6, 0, -0.8), 600, color},
        FrustumLight{{-600, 1500, 1300}, {700, 2000, 1700}, 250, 100, color},
        FrustumLight{{0, 2000, 1200}, {0, 1900, 2300}, 100, 700, color}};
    for (const LightSource& light : lights) {
        stage.rig.sources = {light};
        const Difference off = to_supersampling(stage, 5);
        EXPECT_LT(off.largest, 10) << light.index();
        EXPECT_LT(off.many, 0.01) << light.index();
    }
}

/// Beside what it reflects.
TEST(AreaPicture, EmittingMaterialShowsItsLuminance) {
    Stage stage(flat_plate());
    stage.rig.sources.clear();
    const double dark = green(stage.render(), 48, 27);
    for (Material& material : stage.materials) material.emits = Rgb(30, 40, 50);
    EXPECT_NEAR(green(stage.render(), 48, 27), dark + 40, 1e-4);
}

/// Sheets shine to the side of their normal alone, unless both ways: to cameras as to other bodies.
TEST(AreaPicture, EmittingSheetIsDarkFromBehind) {
    for (const bool both_ways : {false, true})
        for (const bool reversed : {false, true}) {
            Stage stage(flat_plate());
            stage.rig.sources.clear();
            stage.model.faces.front().reversed = reversed;
            for (Material& material : stage.materials) {
                material.emits = Rgb(30, 40, 50);
                material.emits_both_ways = both_ways;
            }
            const SceneMaps sides(stage.materials, stage.model);
            for (const double height : {1500.0, -1500.0}) {
                stage.camera.eye.z = height;
                const PictureScene scene{stage.tracer, stage.materials, stage.rig,
                                         Rgb(7),       nullptr,         &sides};
                const double seen = green(render(scene, stage.camera, {}), 48, 27);
                for (Material& material : stage.materials) material.emits = Rgb(0);
                const double dark = green(render(scene, stage.camera, {}), 48, 27);
                for (Material& material : stage.materials) material.emits = Rgb(30, 40, 50);
                const bool shines = both_ways || (height > 0) != reversed;
                EXPECT_NEAR(seen, dark + (shines ? 40 : 0), 1e-4)
                    << both_ways << reversed << height;
            }
        }
}

/// A body's face stands for it.
TEST(AreaPicture, LightOfABodyIsNotShownItself) {
    LightRig rig;
    rig.sources = {globe, PolygonLight{sky.corners, sky.luminance, true, false}};
    EXPECT_EQ(RigAreas(rig).boxes().size(), 1U);
}

/// The camera sees panels and spheres beside the body, before the background.
TEST(AreaPicture, CameraSeesThemBesideTheBody) {
    Stage stage(flat_plate());
    stage.camera.target = {0, 0, 1500};
    stage.rig.sources = {
        SphereLight{{0, 1000, 1500}, 300, Rgb(50)},
        PolygonLight{{{-500, 2000, 1000}, {500, 2000, 1000}, {500, 2000, 2600}, {-500, 2000, 2600}},
                     Rgb(80)}};
    const Film film = stage.render();
    EXPECT_EQ(film.color.pixel(48, 27)[0], 50); // the sphere is before the panel
    EXPECT_NEAR(green(film, 48, 14), 80, 1e-4);
    EXPECT_EQ(film.color.pixel(2, 27)[0], 7);
}

TEST(AreaPicture, SameBytesForAnyNumberOfThreads) {
    Stage stage(dome());
    stage.rig.sources = {angle, globe};
    EXPECT_EQ(stage.render({}, 1).color.values, stage.render({}, 3).color.values);
}

/// Picture of a plate beside a wall under the sky, with shadows.
Film beside_wall(Stage& stage) {
    stage.rig.sources = {sky};
    const Occluders occluders(stage.model, stage.tracer);
    return render({.tracer = stage.tracer,
                   .materials = stage.materials,
                   .rig = stage.rig,
                   .background = Rgb(7),
                   .occluders = &occluders},
                  stage.camera, {}, {});
}

/// The plate with a wall from a corner along `along`, as high as the sky.
Stage plate_and_wall(const Vec3& corner, const Vec3& along, double refractive_index) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    builder.plane(corner, along, {0, 0, 1999});
    return Stage(builder.build(), refractive_index);
}

/// A narrow lobe shows all of the sky or nothing, though half of the sky's light is hidden.
TEST(AreaPicture, LobeHasTheShareThatIsVisibleInIt) {
    const auto seen = [](const Vec3& corner, const Vec3& along, int x, int y) {
        Stage stage = plate_and_wall(corner, along, 1.5);
        for (Material& material : stage.materials) {
            material.diffuse = Rgb(0);
            material.roughness = Roughness{DistributionKind::phong, 2000, GlossMode::lobe};
        }
        const Film film = beside_wall(stage);
        const Ray ray = stage.camera.ray(x + 0.5, y + 0.5);
        return green(film, x, y) /
               (100 * fresnel_dielectric(-ray.direction.z / ray.direction.length(), 1.5));
    };
    // To the right of the ray, which runs away from the wall.
    EXPECT_NEAR(seen({0.5, -5e5, 0}, {0, 1e6, 0}, 30, 27), 1, 0.01);
    // Across the ray, which ends at the wall.
    EXPECT_NEAR(seen({-5e5, 0.5, 0}, {1e6, 0, 0}, 48, 28), 0, 0.01);
}

/// A wall as high as the sky hides all that is beyond, (1 - sin b) / 2 of the light where its top
/// is b from the vertical.
TEST(AreaPicture, WallHidesTheSkyBeyond) {
    Stage stage = plate_and_wall({-5e5, 0.5, 0}, {1e6, 0, 0}, 1);
    const Film film = beside_wall(stage);
    const Ray ray = PreparedCamera(stage.camera).rays(std::array{Vec2(48.5, 28.5)}).front();
    const double away = 0.5 - ray.at(-ray.origin.z / ray.direction.z).y;
    EXPECT_NEAR(green(film, 48, 28), 10 * (1 + away / std::hypot(away, 2000)), 0.01);
}

} // namespace
} // namespace keiko
