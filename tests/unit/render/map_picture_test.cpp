// Maps in pictures: what they change, and what they must leave.
#include "keiko/maps/scene_maps.h"
#include "keiko/render/shading/mapped_paint.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::dome;
using test::flat_plate;
using test::Stage;

MaterialMap map_of(MappedQuantity drives, TextureKind kind, double size) {
    MaterialMap map;
    map.drives = drives;
    map.texture.kind = kind;
    map.texture.size = size;
    return map;
}

MaterialMap orange_peel(const std::array<double, 5>& um) {
    MaterialMap map = map_of(MappedQuantity::bump, TextureKind::orange_peel, 1);
    map.texture.bands = um;
    return map;
}

/// A stage whose materials have these maps.
struct MappedStage : Stage {
    MappedStage(SurfaceModel body, std::vector<MaterialMap> maps, double refractive_index = 1.5)
        : Stage(std::move(body), refractive_index) {
        for (Material& material : materials) material.maps = maps;
    }

    Film picture(const PictureOptions& options = {}) const {
        const SceneMaps maps(materials, model);
        return keiko::render({tracer, materials, rig, background, occluders, &maps}, camera,
                             options);
    }

    Rgb background{7};
    const Occluders* occluders = nullptr;
};

double green(const Film& film, int x, int y) {
    return static_cast<double>(film.color.pixel(x, y)[1]);
}

double largest_difference(const Film& a, const Film& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.color.values.size(); ++i)
        largest =
            std::max(largest, std::abs(static_cast<double>(a.color.values[i] - b.color.values[i])));
    return largest;
}

TEST(MapPicture, NothingIsLostInAWhiteFurnace) {
    MaterialMap rough = map_of(MappedQuantity::roughness, TextureKind::noise, 40);
    rough.low = Rgb(0.5), rough.high = Rgb(2);
    MaterialMap leather = map_of(MappedQuantity::bump, TextureKind::voronoi, 60);
    leather.high = Rgb(5);
    for (const bool lobes : {false, true}) {
        MappedStage stage(dome(), {leather, orange_peel({0, 0, 1, 5, 20})});
        for (Material& material : stage.materials) {
            material.diffuse = Rgb(1);
            if (lobes) material.roughness = Roughness{}, material.maps.push_back(rough);
        }
        stage.rig.sources.clear(), stage.rig.ambient = Rgb(std::numbers::pi);
        stage.background = Rgb(1);
        const Film film = stage.picture({.aovs = {}, .edge_samples = 1, .min_weight = 0});
        for (const float value : film.color.values)
            ASSERT_NEAR(static_cast<double>(value), 1, lobes ? 5e-3 : 1e-6) << lobes;
    }
}

/// Without a coat the light of the base is its reflectance times the rest.
TEST(MapPicture, DiffuseMapMultipliesTheBase) {
    MaterialMap checker = map_of(MappedQuantity::diffuse, TextureKind::checker, 150);
    checker.low = Rgb(0);
    const MappedStage stage(flat_plate(), {checker}, 1);
    const PictureOptions options{.aovs = {}, .edge_samples = 1};
    const Film mapped = stage.picture(options), plain = stage.render(options);
    const SurfaceMaps maps(stage.materials[0].maps);
    const PreparedCamera camera(stage.camera);
    int light = 0, dark = 0, between = 0;
    for (int y = 20; y < 40; ++y)
        for (int x = 20; x < 76; ++x) {
            const std::array at{Vec2(x + 0.5, y + 0.5)};
            const Rays rays = camera.rays(at);
            const auto hits = stage.tracer.first_hits(rays);
            ASSERT_NE(hits[0], nullptr);
            const MapPlace place{hits[0]->position, hits[0]->normal};
            const double share = green(mapped, x, y) / green(plain, x, y);
            const double exact = maps.values(place).diffuse.g;
            light += share > 0.999, dark += share < 0.001;
            const bool border = share > 0.001 && share < 0.999;
            between += border;
            if (!border) {
                EXPECT_NEAR(share, exact, 2e-3) << x << " " << y;
            }
        }
    EXPECT_GT(light, 200);
    EXPECT_GT(dark, 200);
    EXPECT_GT(between, 50); // pixels on borders show a part
}

TEST(MapPicture, GlossMapMultipliesTheMirrorImage) {
    MaterialMap dull = map_of(MappedQuantity::gloss, TextureKind::checker, 1e6);
    dull.low = dull.high = Rgb(0.25);
    MappedStage stage(flat_plate(), {dull});
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    const Film mapped = stage.picture(), plain = stage.render();
    double largest = 0;
    for (int y = 10; y < 45; ++y)
        for (int x = 10; x < 86; ++x) {
            if (plain.alpha.pixel(x, y)[0] < 1) continue;
            EXPECT_NEAR(green(mapped, x, y), 0.25 * green(plain, x, y), 1e-3);
            largest = std::max(largest, green(plain, x, y));
        }
    EXPECT_GT(largest, 100);
}

TEST(MapPicture, TransmissionMapMultipliesWhatPassesGlass) {
    MaterialMap dim = map_of(MappedQuantity::transmission, TextureKind::checker, 1e6);
    dim.low = dim.high = Rgb(0.5, 0.25, 0);
    MappedStage stage(flat_plate(), {dim});
    for (Material& material : stage.materials)
        material.diffuse = Rgb(0), material.glass = Glass{.pane = 4};
    stage.rig.sources.clear();
    const Film mapped = stage.picture(), plain = stage.render();
    const float *a = mapped.color.pixel(48, 27), *b = plain.color.pixel(48, 27);
    ASSERT_GT(b[0], 5.0F); // of the background, which is 7
    EXPECT_NEAR(static_cast<double>(a[0] / b[0]), 0.5, 1e-6);
    EXPECT_NEAR(static_cast<double>(a[1] / b[1]), 0.25, 1e-6);
    EXPECT_EQ(a[2], 0.0F);
}

TEST(MapPicture, MapsWithoutEffectLeaveThePicture) {
    MaterialMap flat = map_of(MappedQuantity::bump, TextureKind::noise, 50);
    flat.high = Rgb(0);
    MaterialMap white = map_of(MappedQuantity::diffuse, TextureKind::noise, 50);
    white.low = white.high = Rgb(1);
    const MappedStage stage(dome(), {flat, white});
    const PictureOptions options{.aovs = {}, .edge_samples = 1, .light_error = 0};
    EXPECT_LT(largest_difference(stage.picture(options), stage.render(options)), 1e-3);
}

/// Light on bumps is not that between places some pixels apart.
TEST(MapPicture, BumpsAreLitPixelByPixel) {
    MaterialMap bumps = map_of(MappedQuantity::bump, TextureKind::noise, 200);
    bumps.high = Rgb(30);
    MappedStage stage(flat_plate(), {bumps}, 1);
    const Film quick = stage.picture({.edge_samples = 1});
    const Film exact = stage.picture({.edge_samples = 1, .light_error = 0});
    EXPECT_LT(largest_difference(quick, exact), 1e-4);
    EXPECT_GT(largest_difference(exact, stage.render({.edge_samples = 1})), 5);
    const Occluders occluders(stage.model, stage.tracer);
    stage.occluders = &occluders;
    const Film shadowed = stage.picture({.edge_samples = 1});
    const Film reference = stage.picture({.edge_samples = 1, .light_error = 0});
    EXPECT_LT(largest_difference(shadowed, reference), 1e-4);
    EXPECT_LT(largest_difference(shadowed, exact), 0.02 * green(exact, 48, 27));
}

/// Hits of a ray and of one a step aside, both bent.
TEST(MappedHits, BentHitsMirrorAsTheirNeighboursDo) {
    const MappedStage stage(dome(), {orange_peel({0, 0, 0, 10, 100})});
    const SceneMaps maps(stage.materials, stage.model);
    const MappedHits mapped(&maps, stage.materials);
    const PreparedCamera camera(stage.camera);
    const auto mirrored = [&](const Vec2& pixel) {
        const std::array at{pixel};
        const Rays rays = camera.rays(at);
        auto hits = stage.tracer.first_hits(rays);
        mapped.bend(rays[0], hits.hits[0]);
        return reflect_ray(rays[0], hits.hits[0]);
    };
    const Vec2 pixel(50.3, 30.2);
    const double step = 1e-4;
    const Ray middle = mirrored(pixel);
    const Vec3 right = mirrored(pixel + Vec2(step, 0)).direction;
    const Vec3 left = mirrored(pixel - Vec2(step, 0)).direction;
    const Vec3 slope = (right - left) / (2 * step);
    ASSERT_TRUE(middle.differentials);
    EXPECT_LT((middle.differentials->direction_dx - slope).length(), 0.02 * slope.length());
    const MappedStage plain(dome(), {});
    const auto flat = [&](const Vec2& p) {
        const std::array at{p};
        const Rays rays = camera.rays(at);
        return reflect_ray(rays[0], *stage.tracer.first_hits(rays)[0]);
    };
    EXPECT_GT((flat(pixel).differentials->direction_dx - slope).length(), 0.2 * slope.length());
}

TEST(MappedHits, SteepBumpsStayInSight) {
    MaterialMap steep = map_of(MappedQuantity::bump, TextureKind::noise, 20);
    steep.high = Rgb(200);
    const MappedStage stage(flat_plate(), {steep});
    const SceneMaps maps(stage.materials, stage.model);
    const MappedHits mapped(&maps, stage.materials);
    int steepest = 0;
    for (int i = 0; i < 200; ++i) {
        Ray ray;
        ray.origin = {-900 + 8.3 * i, -900, 300}, ray.direction = {0, 1, -0.4};
        auto hits = stage.tracer.first_hits(std::array{ray});
        ASSERT_NE(hits[0], nullptr);
        Hit& hit = hits.hits[0];
        mapped.bend(ray, hit);
        EXPECT_NEAR(hit.normal.length(), 1, 1e-12);
        EXPECT_LT(hit.normal.dot(ray.direction), 0);
        EXPECT_GT(reflect(ray.direction, hit.normal).z, 0);
        steepest += hit.normal.z < 0.98;
    }
    EXPECT_GT(steepest, 100);
}

} // namespace
} // namespace keiko
