#include "keiko/light/fog/window_beam.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/sky/sky_light.h"
#include "keiko/math/quadrature.h"
#include "keiko/volumes/lit_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {
namespace {

/// A cube of uniform voxels, 100 mm wide.
SceneVolumes cube(const VolumeSpec& look) {
    VolumeSpec spec = look;
    spec.voxels.spacing = Vec3(10);
    std::vector<Volume> volumes;
    volumes.emplace_back(spec, VoxelGrid({11, 11, 11}, std::vector<float>(1331, 1.0F)), Job{});
    return SceneVolumes(std::move(volumes));
}

TEST(CloudLight, OfAThinUniformCloudInUniformLightIsItsShareOfThatLight) {
    VolumeSpec spec;
    spec.extinction.points = {{0, 1e-3}}; // 1/m
    for (const PhaseFunction& phase :
         {PhaseFunction(HazePhase{0}), PhaseFunction(HenyeyGreenstein{0.3})}) {
        spec.scattering = VolumeScattering{.albedo = Rgb(0.5, 1, 0.25), .phase = phase};
        const SceneVolumes scene = cube(spec);
        LightRig rig;
        rig.ambient = Rgb(std::numbers::pi * 200); // 200 cd/m2 from all sides
        const FrontToBack cast =
            LitVolumes(scene, rig).along({Vec3(-99, 50, 50), Vec3(199, 50, 50)});
        EXPECT_NEAR(cast.light.g / cast.opacity, 200, 0.6);
        EXPECT_NEAR(cast.light.r / cast.light.g, 0.5, 1e-9);
    }
}

TEST(CloudLight, OfALayerOfKilometresIsDimmedByAllOfIt) {
    VolumeSpec spec;
    spec.voxels.spacing = Vec3(4e6); // mm: 40 km in all
    spec.extinction.points = {{0, 1e-4}};
    spec.scattering = VolumeScattering{};
    LightRig rig;
    rig.sources.push_back(Sun{.direction = Vec3(0, 0, -1), .illuminance = Rgb(1000)});
    std::vector<Volume> volumes;
    volumes.emplace_back(spec, VoxelGrid({11, 11, 11}, std::vector<float>(1331, 0.0F)), Job{});
    const SceneVolumes scene(std::move(volumes));
    EXPECT_GE(scene.reach_from(Vec3(0, 0, -5e6)), 45e6);
    const FrontToBack cast =
        LitVolumes(scene, rig).along({Vec3(-1, 2e7, 1e6), Vec3(1e6, 2e7, 1e6)});
    const double unit = 0.9 * 1000 / (4 * std::numbers::pi);
    EXPECT_NEAR(cast.light.g / cast.opacity, unit * std::exp(-1e-4 * 39e3), 1e-3 * unit);
}

TEST(CloudLight, CountsAUniformMediumInsteadOfTheVoxels) {
    // A layer without extinction towards the sun, which the voxels know of.
    std::vector<float> values;
    for (int k = 0; k < 11; ++k) values.insert(values.end(), 121, k < 5 ? 1.0F : 0.0F);
    VolumeSpec spec;
    spec.voxels.spacing = Vec3(10);
    spec.extinction.points = {{0, 0}, {1, 20}};
    LightRig rig;
    rig.sources.push_back(Sun{.direction = Vec3(0, 0, -1), .illuminance = Rgb(1000)});
    const auto seen = [&](bool uniform) {
        spec.scattering = VolumeScattering{.uniform_leg = uniform};
        std::vector<Volume> volumes;
        volumes.emplace_back(spec, VoxelGrid({11, 11, 11}, values), Job{});
        const SceneVolumes scene(std::move(volumes));
        const FrontToBack cast =
            LitVolumes(scene, rig).along({Vec3(-99, 50, 20), Vec3(199, 50, 20)});
        return cast.light.g / cast.opacity;
    };
    const double unit = 0.9 * 1000 / (4 * std::numbers::pi);
    EXPECT_NEAR(seen(false), unit * std::exp(-0.02 * (20 + 5)), 1e-3 * unit);
    EXPECT_NEAR(seen(true), unit * std::exp(-0.02 * (5.0 / 11) * 80), 1e-3 * unit);
}

TEST(CloudLight, OfOneVolumeIsDimmedByAnother) {
    VolumeSpec lower, upper;
    lower.extinction.points = upper.extinction.points = {{0, 10}};
    lower.scattering = VolumeScattering();
    lower.voxels.spacing = upper.voxels.spacing = Vec3(10);
    upper.placement = Affine::translate(Vec3(0, 0, 500));
    LightRig rig;
    rig.sources.push_back(Sun{.direction = Vec3(0, 0, -1), .illuminance = Rgb(1000)});
    const VoxelGrid grid({11, 11, 11}, std::vector<float>(1331, 1.0F));
    const Segment way{Vec3(-99, 50, 50), Vec3(199, 50, 50)};
    std::vector<Volume> alone, both;
    alone.emplace_back(lower, grid, Job{});
    both.emplace_back(lower, grid, Job{}), both.emplace_back(upper, grid, Job{});
    const SceneVolumes one(std::move(alone)), two(std::move(both));
    EXPECT_NEAR(LitVolumes(two, rig).along(way).light.g,
                LitVolumes(one, rig).along(way).light.g * std::exp(-1), 1e-4);
}

TEST(CloudLight, IsHiddenBySurfaces) {
    VolumeSpec spec;
    spec.extinction.points = {{0, 10}};
    spec.scattering = VolumeScattering();
    const SceneVolumes scene = cube(spec);
    const Vec3 direction = Vec3(1, 0, -2).normalized();
    LightRig rig;
    rig.sources.push_back(Sun{.direction = direction, .illuminance = Rgb(1000)});
    // A plate at the height 200 mm, over x below 0: its edge shades x below 75 mm at 50 mm.
    const StopOfLight plate = [](const Vec3& from, const Vec3& way) {
        const double t = (200 - from.z) / way.z;
        return t > 0 && from.x + way.x * t < 0 ? t : std::numeric_limits<double>::infinity();
    };
    const LitVolumes free(scene, rig), shaded(scene, rig, plate);
    const auto along_y = [](const LitVolumes& lit, double x) {
        return lit.along({Vec3(x, -50, 50), Vec3(x, 150, 50)}).light.g;
    };
    EXPECT_LT(along_y(shaded, 40), 1e-6 * along_y(free, 40));
    EXPECT_NEAR(along_y(shaded, 95), along_y(free, 95), 1e-9);
}

TEST(CloudLight, IsHiddenBySurfacesFarAway) {
    VolumeSpec spec;
    spec.extinction.points = {{0, 10}};
    spec.scattering = VolumeScattering();
    const SceneVolumes scene = cube(spec);
    LightRig rig;
    rig.sources.push_back(Sun{.direction = Vec3(0, 0, -1), .illuminance = Rgb(1000)});
    const auto light_under_plate_at = [&](double height) {
        const StopOfLight plate = [&](const Vec3& from, const Vec3& way) {
            const double t = (height - from.z) / way.z;
            return t > 0 ? t : std::numeric_limits<double>::infinity();
        };
        return LitVolumes(scene, rig, plate).along({Vec3(50, -50, 50), Vec3(50, 150, 50)}).light.g;
    };
    const double free = light_under_plate_at(-1000); // ten cubes below
    EXPECT_GT(free, 1);
    EXPECT_LT(light_under_plate_at(1000), 1e-6 * free);
    EXPECT_LT(light_under_plate_at(1e6), 1e-6 * free);
}

/// Sum of the lights at a place, each dimmed by a march of its own towards it.
Rgb by_marches(const SceneVolumes& scene, const LightRig& rig, const VolumeScattering& scattering,
               const Vec3& place, const Vec3& to_viewer) {
    const DistantLights lights = distant_lights(rig);
    Rgb sum;
    for (const auto* all : {&lights.suns, &lights.surroundings})
        for (const ParallelLight& light : *all) {
            const Segment way{place, place + light.towards * scene.reach_from(place)};
            sum += light.illuminance * phase(scattering.phase, -light.towards.dot(to_viewer)) *
                   std::exp(-scene.optical_depth(way, 50));
        }
    return sum * scattering.albedo;
}

TEST(CloudView, HasTheLightsOfMarchesFromEachPlace) {
    constexpr int nodes = 65;
    std::vector<float> values;
    for (int k = 0; k < nodes; ++k)
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i) {
                const double away = (Vec3(i, j, k) - Vec3(32)).length();
                values.push_back(static_cast<float>(std::clamp(
                    1.2 - away / 26 + 0.2 * std::sin(0.4 * i) * std::cos(0.3 * j), 0.0, 1.0)));
            }
    VolumeSpec spec;
    spec.voxels.spacing = Vec3(10);
    spec.extinction.points = {{0, 0}, {1, 20}}; // up to a depth of 10
    spec.scattering =
        VolumeScattering{.albedo = Rgb(0.9, 0.8, 0.7), .phase = HenyeyGreenstein{0.5}};
    std::vector<Volume> volumes;
    volumes.emplace_back(spec, VoxelGrid({nodes, nodes, nodes}, values), Job{});
    const SceneVolumes scene(std::move(volumes));
    LightRig rig;
    rig.ambient = Rgb(300, 400, 500);
    rig.sources.push_back(Sun{.direction = Vec3(1, 2, -3), .illuminance = Rgb(5000)});
    rig.sources.push_back(SkyLight{.model = SkyModel::overcast, .luminance = Rgb(200)});
    const Volume& volume = scene.volumes().front();
    const CloudLight light(scene, volume, rig, {}, Job{});
    const Vec3 to_viewer = Vec3(-3, 1, 1).normalized();
    CloudView view(light, to_viewer);
    double worst = 0, brightest = 0, sum = 0;
    constexpr int places = 400;
    for (int i = 0; i < places; ++i) {
        const Vec3 place(5 + 54 * (i * 0.754877666 - std::floor(i * 0.754877666)),
                         5 + 54 * (i * 0.569840291 - std::floor(i * 0.569840291)), 5 + 0.135 * i);
        const Rgb expected =
            by_marches(scene, rig, *spec.scattering, volume.scene_place(place), to_viewer);
        const Rgb found = view.luminance(place);
        brightest = std::max(brightest, expected.g);
        sum += std::abs(found.g - expected.g);
        worst = std::max({worst, std::abs(found.r - expected.r), std::abs(found.g - expected.g),
                          std::abs(found.b - expected.b)});
    }
    RecordProperty("worst", std::to_string(worst / brightest));
    RecordProperty("mean", std::to_string(sum / places / brightest));
    EXPECT_LT(worst, 0.02 * brightest);
    EXPECT_LT(sum / places, 0.003 * brightest);
}

/// cd/m2 per steradian that a thin cloud scatters to a viewer of a clear sky, by a fine grid.
double of_whole_sky(const SkyLight& sky, const PhaseFunction& function, const Vec3& to_viewer) {
    const SkyDistribution shares(sky);
    constexpr int rows = 300, columns = 600;
    double sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double z = (i + 0.5) / rows, azimuth = 2 * std::numbers::pi * (j + 0.5) / columns;
            const double across = std::sqrt(1 - z * z);
            const Vec3 towards(across * std::cos(azimuth), across * std::sin(azimuth), z);
            sum += shares(towards) * phase(function, -towards.dot(to_viewer));
        }
    return sky.luminance.g * sum * 2 * std::numbers::pi / rows / columns;
}

/// Largest error of the few directions, relative to the brightest, over views from all round.
double clear_sky_error(const PhaseFunction& function) {
    LightRig rig;
    const SkyLight sky{
        .model = SkyModel::clear, .luminance = Rgb(3000), .sun = Vec3(0.5, 0.3, 0.6).normalized()};
    rig.sources.push_back(sky);
    double worst = 0, brightest = 0;
    for (int i = 0; i < 24; ++i) {
        const double azimuth = 2.4 * i, z = (i + 0.5) / 12 - 1, across = std::sqrt(1 - z * z);
        const Vec3 to_viewer(across * std::cos(azimuth), across * std::sin(azimuth), z);
        double sum = 0;
        for (const ParallelLight& light : distant_lights(rig).surroundings)
            sum += light.illuminance.g * phase(function, -light.towards.dot(to_viewer));
        const double whole = of_whole_sky(sky, function, to_viewer);
        worst = std::max(worst, std::abs(sum - whole)), brightest = std::max(brightest, whole);
    }
    return worst / brightest;
}

TEST(DistantLights, OfAClearSkyScatterAboutWhatTheWholeSkyDoes) {
    EXPECT_LT(clear_sky_error(HazePhase{0}), 0.02);
    EXPECT_LT(clear_sky_error(HenyeyGreenstein{0.3}), 0.05);
    EXPECT_LT(clear_sky_error(HenyeyGreenstein{0.6}), 0.25);
}

/// A soft ball of 33 nodes 10 mm apart, up to 5 deep, with samples `step` mm apart.
SceneVolumes soft_ball(double step) {
    std::vector<float> values;
    for (int k = 0; k < 33; ++k)
        for (int j = 0; j < 33; ++j)
            for (int i = 0; i < 33; ++i)
                values.push_back(static_cast<float>(
                    std::clamp(1 - (Vec3(i, j, k) - Vec3(16)).length() / 15, 0.0, 1.0)));
    VolumeSpec spec;
    spec.voxels.spacing = Vec3(10);
    spec.extinction.points = {{0, 0}, {1, 30}};
    spec.scattering = VolumeScattering{.phase = HenyeyGreenstein{0.4}};
    spec.step = step;
    std::vector<Volume> volumes;
    volumes.emplace_back(spec, VoxelGrid({33, 33, 33}, values), Job{});
    return SceneVolumes(std::move(volumes));
}

TEST(CloudLight, DoesNotDependOnTheStepByMoreThanALevelOfDisplays) {
    LightRig rig;
    rig.ambient = Rgb(500);
    rig.sources.push_back(Sun{.direction = Vec3(1, -2, -2), .illuminance = Rgb(5000)});
    const SceneVolumes usual = soft_ball(0), fine = soft_ball(0.7), finer = soft_ball(0.25);
    const LitVolumes lit(usual, rig), with_fine(fine, rig), with_finer(finer, rig);
    double worst = 0, brightest = 0;
    for (int i = 0; i < 60; ++i) {
        const Segment way{Vec3(-200, 40 + 4 * i, 300 - 3 * i), Vec3(500, 60 + 3 * i, 50 + 2 * i)};
        const double light = lit.along(way).light.g;
        brightest = std::max(brightest, light);
        worst = std::max({worst, std::abs(light - with_fine.along(way).light.g),
                          std::abs(light - with_finer.along(way).light.g)});
    }
    EXPECT_LT(worst, brightest / 255);
}

TEST(DistantLights, HaveTheSolidAngleOfAllDirections) {
    LightRig rig;
    rig.ambient = Rgb(std::numbers::pi);
    rig.sources.push_back(SkyLight{.model = SkyModel::overcast, .luminance = Rgb(9)});
    double below = 0, above = 0, level = 0;
    for (const ParallelLight& light : distant_lights(rig).surroundings) {
        (light.towards.z < 0 ? below : above) += light.illuminance.g;
        if (light.towards.z > 0) level += light.illuminance.g * light.towards.z;
    }
    EXPECT_NEAR(below, 2 * std::numbers::pi, 1e-12);
    // (1 + 2 sin) / 3 of 9 cd/m2 has a mean of 6; a level surface gets 7 pi / 9 of it.
    EXPECT_NEAR(above, 2 * std::numbers::pi * (1 + 6), 1e-12);
    EXPECT_NEAR(level, std::numbers::pi * (1 + 9 * 7.0 / 9), 1e-12);
}

} // namespace
} // namespace keiko
