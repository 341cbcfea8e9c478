// Surroundings by a picture, and pictures of surroundings.
#include "keiko/render/panorama_film.h"

#include "keiko/film/image_file.h"
#include "keiko/maps/scene_maps.h"

#include "tests/support/temporary_folder.h"
#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::dome;
using test::flat_plate;
using test::Stage;

double green(const Film& film, int x, int y) {
    return static_cast<double>(film.color.pixel(x, y)[1]);
}

/// A picture file of one colour.
class PlainPicture {
public:
    explicit PlainPicture(float value) {
        write_film(file(), Film{Image(256, 128, 3, value), Image(256, 128, 1, 1), {}});
    }
    std::filesystem::path file() const { return folder_.path() / "plain.exr"; }

private:
    test::TemporaryFolder folder_;
};

Film render_in(const Stage& stage, const EnvironmentSpec& environment) {
    const SceneMaps maps(stage.materials, stage.model, environment);
    return render({stage.tracer, stage.materials, stage.rig, Rgb(7), nullptr, &maps}, stage.camera,
                  {.aovs = {}, .edge_samples = 1, .min_weight = 0});
}

TEST(PanoramaFilm, NothingIsLostInAWhitePanorama) {
    const PlainPicture white(1);
    for (const int kind : {0, 1, 2}) {
        Stage stage(dome());
        stage.rig.sources.clear();
        for (Material& material : stage.materials) {
            material.diffuse = Rgb(1);
            if (kind == 1) material.roughness = Roughness{};
            if (kind == 2) material.diffuse = Rgb(0), material.glass = Glass{.pane = 4};
        }
        const Film film = render_in(stage, {.file = white.file()});
        for (const float value : film.color.values)
            ASSERT_NEAR(static_cast<double>(value), 1, 1e-4) << kind;
    }
}

TEST(PanoramaFilm, SurroundingsHideFromTheCameraAndLightNothingIfTold) {
    const PlainPicture white(1);
    Stage stage(flat_plate(), 1);
    stage.rig.sources.clear();
    const EnvironmentSpec seen{.file = white.file(), .luminance = Rgb(30)};
    EnvironmentSpec hidden = seen;
    hidden.visible = false, hidden.lights = false;
    const Film with = render_in(stage, seen), without = render_in(stage, hidden);
    EXPECT_NEAR(green(with, 0, 0), 30, 1e-4);
    EXPECT_NEAR(green(without, 0, 0), 7, 1e-6);
    EXPECT_NEAR(green(with, 48, 27), 0.2 * 30, 0.2); // of the base, by the low orders
    EXPECT_NEAR(green(without, 48, 27), 0, 1e-9);
}

/// Rows of tubes a kilometre away, 0.1 rad wide, in a mirror: by themselves, and by a panorama.
class FarRig {
public:
    FarRig() : stage_(flat_plate()) {
        CPlane row;
        row.origin = {-5e5, 1.4e6, 1e6}, row.u = {1e6, 0, 0}, row.v = {0, 1.2e6, 0};
        row.lamps = 4, row.diameter = 1.5e5, row.pitch = 3e5, row.luminance = Rgb(1000);
        stage_.rig.sources = {row};
        for (Material& material : stage_.materials) material.diffuse = Rgb(0);
    }
    Film by_rig() const { return stage_.render({.aovs = {}, .edge_samples = 1}); }
    Film by_panorama(EnvironmentSpec::Layout layout) const {
        const test::TemporaryFolder folder;
        const auto file = folder.path() / "rig.exr";
        const PictureScene scene{stage_.tracer, stage_.materials, stage_.rig};
        const int width = layout == EnvironmentSpec::Layout::cube ? 256 : 1024;
        write_film(file, render_panorama(scene, {{0, 0, 500}, layout, width}, {}));
        Stage dark = stage_;
        dark.rig.sources.clear();
        return render_in(dark, {.file = file, .layout = layout, .visible = false});
    }

private:
    Stage stage_;
};

TEST(PanoramaFilm, PanoramaOfAFarRigIsTheRigToItsPixel) {
    const FarRig far;
    const Film rig = far.by_rig();
    double peak = 0;
    for (int y = 0; y < 54; ++y)
        for (int x = 0; x < 96; ++x)
            if (rig.alpha.pixel(x, y)[0] == 1) peak = std::max(peak, green(rig, x, y));
    ASSERT_GT(peak, 40);
    for (const auto layout : {EnvironmentSpec::Layout::lat_long, EnvironmentSpec::Layout::cube}) {
        const Film panorama = far.by_panorama(layout);
        double sum = 0, off = 0;
        int lit = 0, whole = 0;
        for (int y = 0; y < 54; ++y)
            for (int x = 0; x < 96; ++x) {
                if (rig.alpha.pixel(x, y)[0] < 1) continue;
                const double a = green(rig, x, y), b = green(panorama, x, y);
                sum += a, off += b - a;
                lit += a > 1;
                whole += std::abs(a - b) < 0.02 * peak;
                // On a lamp's edge both see as much of it to a pixel of the panorama.
                EXPECT_NEAR(a, b, 0.4 * peak) << x << " " << y;
            }
        EXPECT_GT(lit, 300);
        EXPECT_GT(whole, lit) << off;
        EXPECT_LT(std::abs(off), 0.01 * sum);
    }
}

TEST(PanoramaFilm, ThreadsDoNotMatter) {
    const Stage stage(dome());
    const PictureScene scene{stage.tracer, stage.materials, stage.rig};
    const PanoramaView view{{0, 0, 600}, EnvironmentSpec::Layout::lat_long, 64};
    const Film one = render_panorama(scene, view, {}, {.progress = {}, .stop = {}, .threads = 1});
    const Film two = render_panorama(scene, view, {}, {.progress = {}, .stop = {}, .threads = 2});
    EXPECT_EQ(one.color.values, two.color.values);
    EXPECT_EQ(one.color.width, 64);
    EXPECT_EQ(one.color.height, 32);
}

} // namespace
} // namespace keiko
