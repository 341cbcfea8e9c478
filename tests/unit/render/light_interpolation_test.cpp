#include "keiko/render/lighting/light_interpolation.h"

#include "keiko/render/antialias/edge_pixel_lighting.h"
#include "keiko/render/shading/direct_lighting.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

using namespace keiko;
using test::Stage;

namespace {

/// A screen of matt paint over the plate that hides some of the lamps.
Stage shaded_plate(double height) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    builder.plane({-400, 600, height}, {800, 0, 0}, {0, 300, 0});
    Stage stage(builder.build(), 1);
    stage.camera.width = 384, stage.camera.height = 216;
    return stage;
}

struct Shaded {
    Stage stage;
    Occluders occluders{stage.model, stage.tracer};

    explicit Shaded(double height = 500) : stage(shaded_plate(height)) {}

    Film render(PictureOptions options, int threads = 0) const {
        return keiko::render({stage.tracer, stage.materials, stage.rig, Rgb(7), &occluders},
                             stage.camera, options,
                             {.progress = {}, .stop = {}, .threads = threads});
    }
};

struct Deviation {
    double rms = 0; ///< relative to each pixel's light
    double interpolated = 0, off = 0,
           twice = 0; ///< shares of the pixels: other than exact, by more than allowed, than twice
};

Deviation deviation(const Film& fast, const Film& exact, double allowed) {
    Deviation all;
    int lit = 0;
    for (std::size_t i = 0; i < exact.color.values.size(); ++i) {
        if (exact.alpha.values[i / 3] == 0) continue;
        const double wrong =
            static_cast<double>(fast.color.values[i]) / static_cast<double>(exact.color.values[i]) -
            1;
        all.rms += wrong * wrong;
        all.interpolated += wrong != 0 ? 1 : 0;
        all.off += std::abs(wrong) > allowed ? 1 : 0;
        all.twice += std::abs(wrong) > 2 * allowed ? 1 : 0;
        ++lit;
    }
    return {std::sqrt(all.rms / lit), all.interpolated / lit, all.off / lit, all.twice / lit};
}

/// Shares of `error` and of the pixels.
void expect_hardly_off(const Shaded& shaded, TubeModel tubes, double most_rms, double most_off) {
    PictureOptions options{.aovs = {}, .edge_samples = 1, .light_error = 0, .tubes = tubes};
    const Film exact = shaded.render(options);
    for (const double error : {1e-3, 1e-2}) {
        options.light_error = error;
        const Deviation found = deviation(shaded.render(options), exact, error);
        EXPECT_LT(found.rms, most_rms * error) << error;
        EXPECT_LT(found.off, most_off) << error;
        EXPECT_EQ(found.twice, 0) << error;
        EXPECT_GT(found.interpolated, 1.0 / 6) << error; // not all of it is stairs
    }
}

} // namespace

// Under a row of thin lamps the shadow of the screen is stairs, each with a kink: beside few of
// them the error of light is larger than requested.
TEST(InterpolatedLight, OfAxesIsHardlyOffByMoreThanAllowed) {
    expect_hardly_off(Shaded(), TubeModel::preview, 0.2, 0.01);
}

// Each stair is a ramp of some pixels with a kink at either end.
TEST(InterpolatedLight, OfTubesIsHardlyOffByMoreThanAllowed) {
    expect_hardly_off(Shaded(), TubeModel::picture, 0.3, 0.01);
}

// Thick tubes, whose penumbrae pictures weigh to 3e-3 of a lamp.
TEST(InterpolatedLight, OfExactTubesIsWhatNumbersTell) {
    Shaded shaded;
    auto& row = std::get<CPlane>(shaded.stage.rig.sources[0]);
    row.lamps = 2, row.diameter = 300;
    const auto lux = [&](TubeModel tubes) {
        return shaded
            .render(
                {.aovs = {Aov::illuminance}, .edge_samples = 1, .light_error = 0, .tubes = tubes})
            .aovs.at(Aov::illuminance);
    };
    shaded.stage.camera.width = 96, shaded.stage.camera.height = 54;
    const Image exact = lux(TubeModel::automatic), quick = lux(TubeModel::picture);
    const PreparedRig rig(shaded.stage.rig);
    const DirectLighting lights(rig, &shaded.occluders, shaded.stage.tracer);
    double farthest = 0;
    for (int y = 20; y < 40; ++y)
        for (int x = 30; x < 66; ++x) {
            const Ray ray = shaded.stage.camera.ray(x + 0.5, y + 0.5);
            const auto hit = shaded.stage.tracer.nearest(ray);
            ASSERT_TRUE(hit);
            const Vec3 side = hit->normal.dot(ray.direction) > 0 ? -hit->normal : hit->normal;
            constexpr TubeModel asked = TubeModel::automatic;
            const PointLighting lit(
                rig, hit->position, side, asked, lights.lights(),
                lights.light_visibility(hit->position, side, hit->root, lights.lights(), asked));
            double told = 0;
            for (const Rgb& light : lit.illuminance_by_light()) told += light.g;
            EXPECT_NEAR(double{exact.pixel(x, y)[0]}, told, 1e-6 * told + 1e-9);
            if (told > 0)
                farthest = std::max(farthest, std::abs(double{quick.pixel(x, y)[0]} / told - 1));
        }
    EXPECT_GT(farthest, 5e-4);
    EXPECT_LT(farthest, 0.05);
}

// Lobes are not linear over some pixels where what is seen of the lamps is: it is that which is
// taken so, and the light follows from it.
TEST(InterpolatedLight, OfLobesIsHardlyOffByMoreThanAllowed) {
    Shaded glossy;
    for (Material& material : glossy.stage.materials) {
        material.refractive_index = 1.5;
        material.roughness = Roughness{.width = 0.08};
        material.flakes = FlakeLayer();
    }
    expect_hardly_off(glossy, TubeModel::picture, 1, 0.02);
}

// Plates and wires from two pixels on, narrower than any large square of places, over a plate under
// points of light, a sun and tubes along the wires.
TEST(InterpolatedLight, FindsNarrowShadowsOnFlatSurfaces) {
    test::ModelBuilder builder;
    builder.plane({-400, -200, 0}, {800, 0, 0}, {0, 400, 0});
    for (int i = 0; i < 12; ++i) {
        const double size = 2.6 + 0.5 * i, x = -350 + 61.3 * i;
        builder.plane({x, -120.7, 40}, {size, 0, 0}, {0, size, 0});
        builder.plane({x, 17.3, 40}, {30, 0, 0}, {0, size, 0});
        builder.plane({x, 97.3, 2.0 / (1 + i * i)}, {30, 0, 0}, {0, size, 0});
    }
    Stage stage(builder.build(), 1);
    stage.camera.projection = Projection::orthographic, stage.camera.orthographic_height = 400;
    stage.camera.eye = {0, 0, 1000}, stage.camera.up = {0, 1, 0};
    stage.camera.width = 640, stage.camera.height = 320;
    CPlane tubes = std::get<CPlane>(stage.rig.sources[0]);
    tubes.origin = {-30, -300, 300}, tubes.u = {60, 0, 0}, tubes.v = {0, 600, 0};
    tubes.lamps = 2, tubes.diameter = 3;
    const Occluders occluders(stage.model, stage.tracer);
    for (const LightSource& source :
         {LightSource(Spotlight{.position = {-900, 300, 1000}, .aim = {0, 0, 0}}),
          LightSource(Sun{.direction = {0.3, 0.2, -1}}), LightSource(tubes)}) {
        stage.rig.sources = {source};
        const auto render = [&](double error) {
            return keiko::render({stage.tracer, stage.materials, stage.rig, Rgb(0), &occluders},
                                 stage.camera,
                                 {.aovs = {}, .edge_samples = 1, .light_error = error});
        };
        constexpr double error = 2e-3;
        const Deviation found = deviation(render(error), render(0), error);
        EXPECT_EQ(found.twice, 0) << source.index();
        // That of the sun is uniform, so that the interpolated light is exact.
        const bool even = std::holds_alternative<Sun>(source);
        EXPECT_TRUE(even || found.interpolated > 0.05) << source.index();
    }
}

TEST(InterpolatedLight, OfNoErrorIsThatOfEachRay) {
    const Shaded shaded;
    const Film film = shaded.render({.aovs = {}, .edge_samples = 1, .light_error = 0});
    const PictureOptions options;
    const PictureScene scene{shaded.stage.tracer, shaded.stage.materials, shaded.stage.rig, Rgb(7),
                             &shaded.occluders};
    const Integrator integrator(scene, options);
    for (int y = 3; y < 216; y += 20)
        for (int x = 5; x < 384; x += 20) {
            const std::vector<Ray> ray{shaded.stage.camera.ray(x + 0.5, y + 0.5)};
            EXPECT_EQ(film.color.pixel(x, y)[1],
                      static_cast<float>(integrator.follow(ray).samples[0].luminance.g))
                << x << " " << y;
        }
}

TEST(InterpolatedLight, IsTheSameForAnyThreadCount) {
    const Shaded shaded;
    EXPECT_EQ(shaded.render({}, 1).color.values, shaded.render({}, 2).color.values);
}

// A pixel across the rim of the screen: both surfaces are lit, each once.
TEST(SharedLight, LightsEachSurfaceOfAPixelOnce) {
    const Shaded shaded(100);
    const Camera& camera = shaded.stage.camera;
    const PictureOptions options;
    const PictureScene scene{shaded.stage.tracer, shaded.stage.materials, shaded.stage.rig, Rgb(7),
                             &shaded.occluders};
    const Integrator integrator(scene, options);
    const Vec2 rim = *project(camera, {0, 600, 100});
    Rays rays;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            rays.push_back(camera.ray(rim.x + i / 4.0 - 0.4, rim.y + j / 4.0 - 0.4));
    SampleBatch view = integrator.view(rays);
    ASSERT_EQ(view.points.size(), 16u);
    RefinedPixels pixel;
    for (const PixelSample& sample : view.samples) pixel.parts.push_back({0, 1.0 / 16, sample});
    pixel.points = view.points;
    add_shared_light(integrator, 1, options.light_error, pixel);
    std::vector<double> screen, plate;
    for (const Subpixel& part : pixel.parts)
        (part.sample.hit->face == 1 ? screen : plate).push_back(part.sample.luminance.g);
    ASSERT_FALSE(screen.empty());
    ASSERT_FALSE(plate.empty());
    for (const auto* surface : {&screen, &plate})
        EXPECT_EQ(std::count(surface->begin(), surface->end(), surface->front()),
                  static_cast<std::ptrdiff_t>(surface->size()));
    EXPECT_GT(std::abs(screen.front() - plate.front()), 0.05 * plate.front());
}

// The rims of the screen over its own shadow, and of the plate: rows of outlined pixels, in which
// few places are computed.
TEST(SharedLight, AlongOutlinesIsHardlyOffByMoreThanAllowed) {
    const Shaded shaded(100);
    PictureOptions options{.aovs = {}, .edge_samples = 1, .light_error = 0};
    const Film whole = shaded.render(options);
    options.edge_samples = 8;
    const Film exact = shaded.render(options);
    for (const double error : {1e-3, 1e-2}) {
        options.light_error = error;
        const Film fast = shaded.render(options);
        int outlined = 0, off = 0, between = 0;
        for (std::size_t i = 0; i < exact.color.values.size(); i += 3) {
            const double is = fast.color.values[i], wanted = exact.color.values[i];
            if (exact.color.values[i] == whole.color.values[i]) continue;
            ++outlined;
            off += std::abs(is - wanted) > error * wanted ? 1 : 0;
            between += is != wanted ? 1 : 0;
        }
        EXPECT_GT(outlined, 300);
        EXPECT_GT(between, outlined / 2) << error;
        EXPECT_LT(off, 0.05 * outlined) << error;
    }
}

// Bars over a plate under a point of light: where their shadows, six pixels wide, cross the rims of
// the plate, in every phase against rows of outlined pixels, none is lit.
TEST(SharedLight, FindsNarrowShadowsThatCrossAnOutline) {
    test::ModelBuilder builder;
    builder.plane({-140, -50.4, 0}, {280, 0, 0}, {0, 100.8, 0});
    for (int i = 0; i < 10; ++i) builder.plane({-130.0 + 27 * i, -120, 50}, {6, 0, 0}, {0, 240, 0});
    Stage stage(builder.build(), 1);
    stage.rig.sources = {Spotlight{.position = {-3000, 0, 3000}, .aim = {0, 0, 0}}};
    stage.camera.projection = Projection::orthographic, stage.camera.orthographic_height = 160;
    stage.camera.eye = {0, 0, 1000}, stage.camera.up = {0, 1, 0};
    stage.camera.width = 320, stage.camera.height = 160;
    const Occluders occluders(stage.model, stage.tracer);
    const auto render = [&](double error) {
        return keiko::render({stage.tracer, stage.materials, stage.rig, Rgb(0), &occluders},
                             stage.camera, {.aovs = {}, .light_error = error});
    };
    const Film exact = render(0), fast = render(2e-3);
    int dark = 0;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 320; ++x) {
            const float wanted = exact.color.pixel(x, y)[1];
            dark += wanted == 0 ? 1 : 0;
            EXPECT_NEAR(fast.color.pixel(x, y)[1], wanted, 0.01F * wanted) << x << " " << y;
        }
    EXPECT_GT(dark, 1000);
}
