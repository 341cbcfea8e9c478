#include "keiko/render/lighting/fitted_light.h"

#include "keiko/film/tone_mapping.h"
#include "keiko/visibility/query/occluders.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

using namespace keiko;
using test::Stage;

namespace {

/// A dome on a plate, under a row of lamps that it nearly touches.
Stage domed_plate() {
    test::ModelBuilder builder;
    test::add_dome(builder);
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    Stage stage(builder.build());
    auto& row = std::get<CPlane>(stage.rig.sources[0]);
    row.origin = {-1200, -1200, 400}, row.u = {2400, 0, 0}, row.v = {0, 2400, 0};
    row.lamps = 8;
    stage.camera.width = 384, stage.camera.height = 216;
    return stage;
}

Stage glossy(Stage stage) {
    for (Material& material : stage.materials) {
        material.roughness = Roughness{.width = 0.08};
        material.flakes = FlakeLayer();
    }
    return stage;
}

/// Shares of the covered pixels.
struct Deviation {
    double rms = 0; ///< relative to each pixel's luminance
    double fitted = 0, off = 0,
           far_off = 0; ///< other than exact; by more than allowed; than 5 times
};

Deviation deviation(const Film& fast, const Film& exact, double allowed) {
    Deviation all;
    double covered = 0;
    for (std::size_t i = 0; i < exact.color.values.size(); i += 3) {
        if (exact.alpha.values[i / 3] == 0) continue;
        const double is = fast.color.values[i + 1], wanted = exact.color.values[i + 1];
        const double wrong = is / wanted - 1;
        all.rms += wrong * wrong;
        all.fitted += wrong != 0 ? 1 : 0;
        all.off += std::abs(wrong) > allowed ? 1 : 0;
        all.far_off += std::abs(wrong) > 5 * allowed ? 1 : 0;
        ++covered;
    }
    return {std::sqrt(all.rms / covered), all.fitted / covered, all.off / covered,
            all.far_off / covered};
}

void expect_hardly_off(const Stage& stage, int edge_samples, double least_fitted) {
    PictureOptions options{.aovs = {}, .edge_samples = edge_samples, .light_error = 0};
    const Film exact = stage.render(options);
    for (const double error : {1e-3, 1e-2}) {
        options.light_error = error;
        const Deviation found = deviation(stage.render(options), exact, error);
        EXPECT_LT(found.rms, 0.3 * error) << error;
        EXPECT_LT(found.off, 0.01) << error;
        EXPECT_EQ(found.far_off, 0) << error;
        EXPECT_GT(found.fitted, least_fitted) << error;
    }
}

/// A square of 24 x 24 pixels on the dome's top, whose normals swing by 25 degrees from pixel to
/// pixel.
std::vector<ShadingPoint> corrugated_square() {
    std::vector<ShadingPoint> points(24 * 24);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = static_cast<double>(i % 24), y = static_cast<double>(i / 24);
        const double swing = 0.22 * std::sin(2 * x + 0.3 * y), sway = 0.1 * std::sin(0.2 * y);
        points[i].place = {
            {4 * x, 4 * y, 200}, Vec3(swing, sway, std::sqrt(1 - swing * swing - sway * sway)), 0};
        points[i].eye = {0, 0, 1}, points[i].weight = Rgb(1);
    }
    return points;
}

/// Light of the square from the fit, less that of each of its places by itself, as a share of it.
std::vector<double> errors_of_square(const Stage& stage, double allowed) {
    const PictureOptions options;
    const PictureScene scene{stage.tracer, stage.materials, stage.rig};
    const Integrator integrator(scene, options);
    const std::vector<ShadingPoint> points = corrugated_square();
    std::vector<LitPlace> places;
    for (std::size_t i = 0; i < points.size(); ++i)
        places.push_back(
            {{static_cast<int>(i % 24), static_cast<int>(i / 24)}, &points[i], Rgb(0)});
    const std::vector<DirectLight> light =
        fitted_light(integrator, integrator.lights(), places, allowed);
    std::vector<double> errors;
    for (std::size_t i = 0; i < points.size(); ++i)
        errors.push_back(light[i].illuminance.g / integrator.direct_light(points[i]).illuminance.g -
                         1);
    return errors;
}

/// A dome on a plate and a board above them, under an overcast sky and ground.
Stage under_the_sky() {
    test::ModelBuilder builder;
    test::add_dome(builder);
    builder.plane({-2000, -2000, 0}, {4000, 0, 0}, {0, 4000, 0});
    builder.plane({-800, -700, 330}, {1300, 0, 60}, {0, 1000, 0});
    Stage stage(builder.build(), 1);
    SkyLight sky{SkyModel::overcast, Rgb(900, 600, 300)};
    sky.ground = Rgb(90);
    stage.rig.sources = {sky};
    stage.camera.width = 192, stage.camera.height = 108;
    return stage;
}

Film with_shadows(const Stage& stage, const PictureOptions& options) {
    const Occluders occluders(stage.model, stage.tracer);
    return render({.tracer = stage.tracer,
                   .materials = stage.materials,
                   .rig = stage.rig,
                   .background = Rgb(0),
                   .occluders = &occluders},
                  stage.camera, options, {});
}

} // namespace

TEST(FittedLight, IsHardlyOffByMoreThanAllowed) {
    expect_hardly_off(domed_plate(), 1, 0.7);
}

TEST(FittedLight, OfLobesIsHardlyOffByMoreThanAllowed) {
    expect_hardly_off(glossy(domed_plate()), 1, 0.15);
}

TEST(FittedLight, OfPixelsInPartsIsHardlyOffByMoreThanAllowed) {
    expect_hardly_off(domed_plate(), 8, 0.7);
}

// Ridges of three degrees, askew to the pixels: their sides are one smooth surface for pictures,
// and all that betrays small pieces of them is their normals.
TEST(FittedLight, FollowsShallowCreases) {
    test::ModelBuilder builder;
    for (int i = 0; i < 12; ++i) {
        const double rise = i % 2 == 0 ? 5 : -5;
        builder.plane({-1000.0 + 160 * i, -1000, i % 2 == 0 ? 0.0 : 5.0}, {160, 40, rise},
                      {0, 2000, 0});
    }
    Stage stage(builder.build());
    stage.camera.width = 384, stage.camera.height = 216;
    expect_hardly_off(stage, 1, 0.4);
}

// Neighbours that are no smooth surface are lit by one fit of position and normal.
TEST(FittedLight, FitsNormalsThatSwing) {
    std::size_t fitted = 0, off = 0;
    for (const double error : errors_of_square(domed_plate(), 5e-3)) {
        fitted += error != 0 ? 1 : 0, off += std::abs(error) > 5e-3 ? 1 : 0;
        EXPECT_LT(std::abs(error), 5 * 5e-3);
    }
    EXPECT_GT(fitted, 24U * 24U / 2);
    EXPECT_LT(off, 24U * 24U / 50);
}

// The light of lobes follows normals too closely for that: only rows of pixels with like normals
// are fitted.
TEST(FittedLight, HardlyFitsLobesWhereNormalsSwing) {
    std::size_t fitted = 0;
    for (const double error : errors_of_square(glossy(domed_plate()), 5e-3))
        fitted += error != 0 ? 1 : 0;
    EXPECT_LT(fitted, 24U * 24U / 20);
}

TEST(FittedLight, HoldsTheErrorOfTheIlluminance) {
    const Stage stage = domed_plate();
    PictureOptions options{.aovs = {Aov::illuminance}, .edge_samples = 1, .light_error = 0};
    const Image exact = stage.render(options).aovs.at(Aov::illuminance);
    options.light_error = 2e-3;
    const Image fast = stage.render(options).aovs.at(Aov::illuminance);
    std::size_t off = 0, lit = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        if (exact.values[i] == 0) continue;
        ++lit;
        off += std::abs(fast.values[i] / exact.values[i] - 1) > 2e-3F ? 1 : 0;
    }
    EXPECT_GT(lit, 20000U);
    EXPECT_LT(off, lit / 100);
}

// Display values deviate by no more than the error is at white, and more light is fitted.
TEST(FittedLight, HoldsTheErrorAsItIsShown) {
    const Stage stage = domed_plate();
    PictureOptions options{.aovs = {}, .edge_samples = 1, .light_error = 0};
    const Film exact = stage.render(options);
    options.light_error = 1e-3;
    const Film by_share = stage.render(options);
    const double white = 10 * white_luminance(exact);
    options.white = white;
    const Film as_shown = stage.render(options);
    EXPECT_GT(deviation(as_shown, exact, 1).fitted, deviation(by_share, exact, 1).fitted);
    const double allowed = options.light_error * srgb_slope(1);
    std::size_t off = 0, far_off = 0, beyond_share = 0;
    for (std::size_t i = 0; i < exact.color.values.size(); ++i) {
        const double is{as_shown.color.values[i]}, wanted{exact.color.values[i]};
        const double shown = std::abs(srgb_oetf(is / white) - srgb_oetf(wanted / white));
        off += shown > allowed ? 1 : 0, far_off += shown > 5 * allowed ? 1 : 0;
        beyond_share += std::abs(is - wanted) > options.light_error * wanted ? 1 : 0;
    }
    EXPECT_LT(off, exact.color.values.size() / 100);
    EXPECT_EQ(far_off, 0U);
    EXPECT_GT(beyond_share, off);
}

TEST(FittedLight, OfNoErrorIsThatOfEachRay) {
    const Stage stage = glossy(domed_plate());
    const PictureOptions options{.aovs = {}, .edge_samples = 1, .light_error = 0};
    const Film film = stage.render(options);
    const PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    const Integrator integrator(scene, options);
    for (int y = 3; y < 216; y += 20)
        for (int x = 5; x < 384; x += 20) {
            const std::vector<Ray> ray{stage.camera.ray(x + 0.5, y + 0.5)};
            EXPECT_EQ(film.color.pixel(x, y)[1],
                      static_cast<float>(integrator.follow(ray).samples[0].luminance.g))
                << x << " " << y;
        }
}

TEST(FittedLight, IsTheSameForAnyThreadCount) {
    const Stage stage = glossy(domed_plate());
    EXPECT_EQ(stage.render({}, 1).color.values, stage.render({}, 2).color.values);
}

// Places that coincide, whose light differs: without normals in the fit, as for lobes, no halves
// are left to be fitted.
TEST(FittedLight, OfPlacesThatCoincideIsThatOfEach) {
    const Stage stage = glossy(domed_plate());
    const PictureOptions options;
    const PictureScene scene{stage.tracer, stage.materials, stage.rig};
    const Integrator integrator(scene, options);
    std::vector<ShadingPoint> points(40);
    std::vector<LitPlace> places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double turn = 0.1 * static_cast<double>(i % 2);
        points[i].place = {{0, 0, 200}, {std::sin(turn), 0, std::cos(turn)}, 0};
        points[i].eye = {0, 0, 1}, points[i].weight = Rgb(1);
        places.push_back({{static_cast<int>(i), 0}, &points[i], Rgb(0)});
    }
    const std::vector<DirectLight> light =
        fitted_light(integrator, integrator.lights(), places, 1e-3);
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(light[i].illuminance.g, integrator.direct_light(points[i]).illuminance.g);
}

TEST(FittedLight, IsOfRowsWithoutShadowsAndMediumAndOfOpenSkies) {
    const Stage stage = domed_plate();
    const auto is_smooth = [&](const LightRig& rig, const Occluders* occluders) {
        const PictureOptions options;
        const PictureScene scene{stage.tracer, stage.materials, rig, Rgb(0), occluders};
        return !Integrator(scene, options).smooth_lights().empty();
    };
    EXPECT_TRUE(is_smooth(stage.rig, nullptr));
    const Occluders occluders(stage.model, stage.tracer);
    EXPECT_FALSE(is_smooth(stage.rig, &occluders));
    LightRig rig = stage.rig;
    rig.sources.emplace_back(Spotlight());
    EXPECT_FALSE(is_smooth(rig, nullptr));
    rig = stage.rig;
    rig.medium = Medium();
    EXPECT_FALSE(is_smooth(rig, nullptr));
    SkyLight sky{SkyModel::overcast, Rgb(900)};
    rig.sources = {Spotlight(), sky};
    EXPECT_TRUE(is_smooth(rig, &occluders));
    sky.windows = {{{{-1, 0, 5}, {1, 0, 5}, {1, 0, 7}}}};
    rig.sources = {sky};
    EXPECT_FALSE(is_smooth(rig, &occluders));
}

// What is allowed is a share of the light past no body: 600 lx pi 7 / 9 on level ground.
TEST(FittedLight, OfTheSkyIsOffByAShareOfItsWholeLight) {
    const Stage stage = under_the_sky();
    PictureOptions options{.aovs = {Aov::illuminance}, .edge_samples = 1, .light_error = 0};
    const Image exact = with_shadows(stage, options).aovs.at(Aov::illuminance);
    options.light_error = 2e-3;
    const Image fast = with_shadows(stage, options).aovs.at(Aov::illuminance);
    const double whole = 600 * 3.14159 * 7 / 9;
    std::size_t lit = 0, fitted = 0, dark = 0, off = 0;
    double squares = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        if (exact.values[i] == 0) continue;
        const double wrong =
            static_cast<double>(std::abs(fast.values[i] - exact.values[i])) / whole;
        ++lit, squares += wrong * wrong;
        dark += exact.values[i] < 0.7F * static_cast<float>(whole) ? 1 : 0;
        fitted += wrong != 0 ? 1 : 0, off += wrong > 0.01 ? 1 : 0;
        EXPECT_LT(wrong, 0.05) << i;
        EXPECT_GE(fast.values[i], 0) << i;
    }
    EXPECT_GT(dark, lit / 10);
    EXPECT_GT(fitted, lit * 3 / 5);
    EXPECT_LT(off, lit / 200);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(lit)), 0.004);
}

// The sky is fitted, lamps are interpolated: each counts once.
TEST(FittedLight, OfTheSkyAddsUpWithLamps) {
    Stage both = under_the_sky();
    const LightSource sky = both.rig.sources[0];
    PointSource lamp;
    lamp.position = {-500, -300, 900}, lamp.intensity = Rgb(600);
    both.rig.sources = {lamp, sky};
    Stage first = both, second = both;
    first.rig.sources = {lamp}, second.rig.sources = {sky};
    for (const double error : {0.0, 2e-3}) {
        const PictureOptions options{.aovs = {}, .edge_samples = 4, .light_error = error};
        const Film sum = with_shadows(both, options), a = with_shadows(first, options),
                   b = with_shadows(second, options);
        for (std::size_t i = 0; i < sum.color.values.size(); ++i) {
            if (sum.alpha.values[i / 3] < 1) continue; // beside which the sky is seen
            const float parts = a.color.values[i] + b.color.values[i];
            EXPECT_NEAR(sum.color.values[i], parts, (error > 0 ? 0.02F : 1e-5F) * parts) << i;
        }
    }
}

// A bolt some pixels wide stands on a plate: its shadow is shorter than the places of a fit lie
// apart.
TEST(FittedLight, OfTheSkyIsDarkBesideSmallThings) {
    test::ModelBuilder builder;
    builder.plane({-1000, -1000, 0}, {2000, 0, 0}, {0, 2000, 0});
    for (const Vec3& at : {Vec3(-400, -150, 0), Vec3(90, 40, 0), Vec3(310, -420, 0)}) {
        const Vec3 x(60, 0, 0), y(0, 60, 0), z(0, 0, 70);
        builder.plane(at, x, z), builder.plane(at + y, x, z);
        builder.plane(at, y, z), builder.plane(at + x, y, z);
        builder.plane(at + z, x, y);
    }
    Stage stage(builder.build(), 1);
    stage.rig.sources = {SkyLight{SkyModel::uniform, Rgb(100)}};
    stage.camera.width = 192, stage.camera.height = 108;
    PictureOptions options{.aovs = {Aov::illuminance}, .edge_samples = 1, .light_error = 0};
    const Image exact = with_shadows(stage, options).aovs.at(Aov::illuminance);
    options.light_error = 2e-3;
    const Image fast = with_shadows(stage, options).aovs.at(Aov::illuminance);
    int dark = 0;
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
        if (exact.values[i] == 0) continue;
        dark += exact.values[i] < 290 ? 1 : 0;
        EXPECT_NEAR(fast.values[i], exact.values[i], 0.05F * 314.16F) << i % 192 << ' ' << i / 192;
    }
    EXPECT_GT(dark, 100);
}
