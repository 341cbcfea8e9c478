#include "keiko/render/shading/integrator.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace keiko;
using test::dome;
using test::flat_plate;
using test::Stage;

namespace {

double mean_luminance(const Film& film, int x0, int y0, int x1, int y1) {
    double sum = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const float* p = film.color.pixel(x, y);
            sum += luminance(
                {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
        }
    return sum / ((x1 - x0) * (y1 - y0));
}

double largest_difference(const Image& a, const Image& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        largest = std::max(largest, std::abs(static_cast<double>(a.values[i] - b.values[i])));
    return largest;
}

} // namespace

TEST(Render, BackgroundAndCoverageWhereNothingIsHit) {
    const Film film = Stage(flat_plate()).render();
    EXPECT_EQ(film.color.pixel(0, 0)[1], 7);
    EXPECT_EQ(film.alpha.pixel(0, 0)[0], 0);
    EXPECT_EQ(film.alpha.pixel(48, 27)[0], 1);
}

TEST(Render, DenseFogHidesBodyLampsAndBackgroundAlike) {
    for (const double refractive_index : {1.5, 30.0}) {
        Stage stage(flat_plate(), refractive_index);
        stage.rig.medium = Medium{.extinction = Rgb(50), .ambient = Rgb(3)};
        const Film film = stage.render();
        for (int y = 0; y < film.color.height; ++y)
            for (int x = 0; x < film.color.width; ++x)
                ASSERT_NEAR(film.color.pixel(x, y)[0], 3, 1e-5) << x << " " << y;
    }
}

TEST(Render, ThinFogDimsTheBackground) {
    Stage stage(flat_plate());
    stage.rig.medium = Medium{.extinction = Rgb(1e-3), .albedo = Rgb(0), .ambient = Rgb(0)};
    const Film film = stage.render();
    EXPECT_EQ(film.alpha.pixel(0, 0)[0], 0);
    EXPECT_NEAR(film.color.pixel(0, 0)[0], 7 * std::exp(-1.0), 1e-5);
}

TEST(Render, WithoutACoatOnlyTheLitBaseIsLeft) {
    const Stage stage(flat_plate(), 1);
    const Film film = stage.render();
    const float* p = film.color.pixel(48, 27);
    EXPECT_GT(p[0], 0);
    EXPECT_NEAR(p[1] / p[0], 2, 1e-5); // the base's own colour
    EXPECT_NEAR(p[2] / p[0], 3, 1e-5);
}

// Integrating stripes over footprints and sampling them with many rays are two ways to one mean.
TEST(Render, FootprintsAgreeWithSupersampling) {
    for (const SurfaceModel& model : {flat_plate(), dome()}) {
        Stage stage(model);
        stage.camera.width = 384;
        stage.camera.height = 216;
        const Film one = stage.render({.aovs = {}, .edge_samples = 1});
        constexpr int n = 8;
        stage.camera.width *= n;
        stage.camera.height *= n;
        const Film many = stage.render({.aovs = {}, .edge_samples = 1});
        double worst = 0, brightest = 0;
        for (int y = 96; y < 120; ++y)
            for (int x = 168; x < 216; ++x) {
                const double mean = mean_luminance(many, n * x, n * y, n * x + n, n * y + n);
                brightest = std::max(brightest, mean);
                worst = std::max(worst, std::abs(mean_luminance(one, x, y, x + 1, y + 1) - mean));
            }
        EXPECT_GT(brightest, 100);
        EXPECT_LT(worst, 0.03 * brightest);
    }
}

TEST(Render, SameBytesForAnyThreadCount) {
    const Stage stage(dome());
    const PictureOptions options{.aovs = {Aov::luminance, Aov::c_plane_uv}};
    const Film one = stage.render(options, 1), two = stage.render(options, 2);
    EXPECT_EQ(one.color.values, two.color.values);
    EXPECT_EQ(one.aovs.at(Aov::c_plane_uv).values, two.aovs.at(Aov::c_plane_uv).values);
}

// A picture keeps hits only where layers need them, and lights surfaces only where they show it.
// The body: a dome, and an awning beyond a gap without rays.
TEST(Render, MirrorsShowTheSameBesideAnyLayers) {
    test::ModelBuilder builder;
    test::add_dome(builder);
    builder.plane({-900, 200, 1500}, {1800, 0, 0}, {0, 300, 250});
    Stage stage(builder.build());
    for (Material& material : stage.materials) material.diffuse = Rgb(0);
    stage.camera.width = 283, stage.camera.height = 331;
    stage.camera.vertical_fov = 60;
    const std::vector<Aov> told{Aov::luminance, Aov::normal,     Aov::uv,       Aov::face,
                                Aov::depth,     Aov::c_plane_uv, Aov::curvature};
    for (const int max_depth : {0, 1, 3}) {
        const auto render = [&](const std::vector<Aov>& aovs) {
            return stage.render({.aovs = aovs, .edge_samples = 1, .max_depth = max_depth});
        };
        std::vector<Aov> and_light = told;
        and_light.push_back(Aov::illuminance);
        const Film alone = render({}), layers = render(told), lit = render(and_light);
        EXPECT_EQ(alone.color.values, lit.color.values) << max_depth;
        EXPECT_EQ(alone.alpha.values, lit.alpha.values) << max_depth;
        for (const Aov aov : told)
            EXPECT_EQ(layers.aovs.at(aov).values, lit.aovs.at(aov).values) << name_of(aov);
        EXPECT_GT(lit.aovs.at(Aov::illuminance).pixel(141, 200)[0], 0);
        EXPECT_EQ(mean_luminance(alone, 100, 150, 180, 160) > 10, max_depth > 0);
        for (const auto& [y, covered] : {std::pair(10, 1), std::pair(80, 0), std::pair(200, 1)})
            EXPECT_EQ(alone.alpha.pixel(141, y)[0], covered) << y;
    }
}

// Surfaces that reflected rays meet are left out where they show nothing: against paint that takes
// light, but too little for a picture to show.
TEST(Render, MirroredBodiesHideLampsWithoutTheirSurface) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    const SurfaceModel plate = builder.build();
    builder.plane({-300, 800, 0}, {600, 0, 0}, {0, 0, 500});
    Stage stage(builder.build()), open(plate);
    const PictureOptions options{.aovs = {}, .edge_samples = 1, .max_depth = 1};
    const auto painted = [&](Stage& some, double diffuse) {
        for (Material& material : some.materials) material.diffuse = Rgb(diffuse);
        return some.render(options);
    };
    const Film alone = painted(stage, 0), lit = painted(stage, 1e-60), free = painted(open, 0);
    EXPECT_EQ(alone.color.values, lit.color.values);
    std::size_t hidden = 0;
    for (int x = 0; x < stage.camera.width; ++x)
        for (int y = 0; y < stage.camera.height; ++y)
            hidden += alone.color.pixel(x, y)[0] == 0 && free.color.pixel(x, y)[0] > 10;
    EXPECT_GT(hidden, 100u);
}

TEST(Render, AovsTellOfTheFirstHit) {
    const Stage stage(flat_plate());
    const Film film =
        stage.render({.aovs = {Aov::depth, Aov::normal, Aov::face, Aov::uv, Aov::luminance}});
    const Ray center = stage.camera.ray(48.5, 27.5);
    EXPECT_NEAR(film.aovs.at(Aov::depth).pixel(48, 27)[0], -center.origin.z / center.direction.z,
                1e-2);
    EXPECT_EQ(film.aovs.at(Aov::normal).pixel(48, 27)[2], 1);
    EXPECT_EQ(film.aovs.at(Aov::face).pixel(48, 27)[0], 0);
    EXPECT_EQ(film.aovs.at(Aov::face).pixel(0, 0)[0], -1);
    EXPECT_TRUE(std::isinf(film.aovs.at(Aov::depth).pixel(0, 0)[0]));
    EXPECT_NEAR(film.aovs.at(Aov::luminance).pixel(48, 27)[0], mean_luminance(film, 48, 27, 49, 28),
                1e-3);
}

// Matt white shows E / pi, so two ways lead to one picture: shading, and the layer of illuminance.
TEST(Render, IlluminanceIsWhatLightsAMattWhiteBody) {
    Stage stage(dome(), 1);
    for (Material& material : stage.materials) material.diffuse = Rgb(1);
    const Film film = stage.render({.aovs = {Aov::illuminance, Aov::luminance}, .light_error = 0});
    const Image &lux = film.aovs.at(Aov::illuminance), &y = film.aovs.at(Aov::luminance);
    const float brightest = *std::max_element(lux.values.begin(), lux.values.end());
    // A coat, even one that mirrors nothing, leaves out lamps whose axis the horizon hides.
    const double hidden = 1e-5 * double{brightest};
    int lit = 0;
    for (std::size_t i = 0; i < lux.values.size(); ++i) {
        if (film.alpha.values[i] < 1) continue; // its luminance holds background, its lux do not
        const double shown = std::numbers::pi * double{y.values[i]};
        EXPECT_NEAR(double{lux.values[i]}, shown, hidden + 1e-6 * shown);
        lit += shown > 100;
    }
    EXPECT_GT(lit, 500);
    EXPECT_EQ(lux.pixel(0, 0)[0], 0) << "beside the body";
}

TEST(Render, OutlinesAreRefined) {
    const Stage stage(flat_plate());
    const Film rough = stage.render({.aovs = {}, .edge_samples = 1});
    const Film fine = stage.render({.aovs = {}, .edge_samples = 4});
    int between = 0;
    for (const float alpha : fine.alpha.values) between += alpha > 0 && alpha < 1 ? 1 : 0;
    EXPECT_GT(between, 50);
    EXPECT_GT(largest_difference(rough.alpha, fine.alpha), 0.2);
}

// Two plates at right angles: the standing one hides the lamps from part of the lying one.
TEST(Render, TheBodyMirrorsItself) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    builder.plane({-1000, 1000, 0}, {2000, 0, 0}, {0, 0, 4000});
    const Stage corner(builder.build()), alone(flat_plate());
    const PictureOptions options;
    const auto follow = [&](const Stage& stage) {
        const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(0)};
        std::vector<Ray> rays;
        for (int y = 20; y < 34; ++y) rays.push_back(stage.camera.ray(48, y));
        return Integrator(scene, options).follow(rays);
    };
    const SampleBatch blocked_view = follow(corner), open_view = follow(alone);
    const std::vector<PixelSample>&blocked = blocked_view.samples, &open = open_view.samples;
    double brightest_blocked = 0, brightest_open = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
        ASSERT_TRUE(blocked[i].hit && open[i].hit);
        EXPECT_EQ(blocked[i].hit->face, 0u);
        EXPECT_EQ(blocked[i].mirrored_face, 1u);
        EXPECT_FALSE(open[i].mirrored_face);
        brightest_blocked = std::max(brightest_blocked, luminance(blocked[i].luminance));
        brightest_open = std::max(brightest_open, luminance(open[i].luminance));
    }
    EXPECT_GT(brightest_open, 10 * brightest_blocked);
}

// Even surroundings of the luminance 7, the background's: what loses no light cannot be seen, not
// even where the body mirrors itself.
TEST(Render, ABodyWithoutLossVanishesInAWhiteFurnace) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    builder.plane({-1000, 1000, 0}, {2000, 0, 0}, {0, 0, 4000});
    for (const double refractive_index : {1.0, 1.5}) {
        Stage stage(builder.build(), refractive_index);
        stage.rig = {.name = "", .sources = {}, .ambient = Rgb(7 * std::numbers::pi), .medium = {}};
        const Film dark = stage.render();
        EXPECT_LT(*std::min_element(dark.color.values.begin(), dark.color.values.end()), 3);
        EXPECT_LE(*std::max_element(dark.color.values.begin(), dark.color.values.end()), 7 + 1e-5);
        for (Material& material : stage.materials) material.diffuse = Rgb(1);
        const Film white =
            stage.render({.aovs = {}, .light_error = 0, .max_depth = 12, .min_weight = 1e-6});
        for (const float value : white.color.values) ASSERT_NEAR(value, 7, 1e-4);
    }
}
