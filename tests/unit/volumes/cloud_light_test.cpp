#include "keiko/light/fog/window_beam.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/volumes/lit_volumes.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

PhaseFunction phase_of(const test::OracleRow& row) {
    const double parameter = row.number("in.par");
    if (row.text("in.kind") == "hg") return HenyeyGreenstein{parameter};
    return HazePhase{row.text("in.kind") == "iso" ? 0 : parameter};
}

LightRig sun_of(const test::OracleRow& row) {
    LightRig rig;
    rig.sources.push_back(
        Sun{.direction = row.unit("in.dl"), .illuminance = Rgb(row.number("in.E0"))});
    return rig;
}

/// A cloud of these voxels, whose value 1 has the extinction of the row, in 1/m and m.
VolumeSpec cloud_of(const test::OracleRow& row) {
    VolumeSpec spec;
    spec.extinction.points = {{0, 0}, {1, row.number("in.sigma")}};
    spec.scattering = VolumeScattering{.albedo = Rgb(row.number("in.w0")), .phase = phase_of(row)};
    return spec;
}

/// A slab of uniform voxels, so wide that its sides do not matter, in m times 1000.
Volume slab(const test::OracleRow& row) {
    constexpr int layers = 513, across = 5;
    const double height = 1000 * row.number("in.h"), wide = 1e7;
    VolumeSpec spec = cloud_of(row);
    spec.voxels.origin = Vec3(-wide / 2, -wide / 2, 0);
    spec.voxels.spacing = Vec3(wide / (across - 1), wide / (across - 1), height / (layers - 1));
    return {spec,
            VoxelGrid({across, across, layers}, std::vector<float>(across * across * layers, 1.0F)),
            Job{}};
}

TEST(ScatterSlab, AgreesWithOracle) {
    const test::OracleTable table("scatter_slab");
    test::WorstError light("L"), passed("T_direct");
    for (const auto& row : table) {
        std::vector<Volume> volumes;
        volumes.push_back(slab(row));
        const SceneVolumes scene(std::move(volumes));
        const LitVolumes lit(scene, sun_of(row));
        const Vec3 leaves = row.unit("in.v"), sun = row.unit("in.dl");
        const double height = 1000 * row.number("in.h");
        const double tau = row.number("in.sigma") * row.number("in.h");
        EXPECT_NEAR(tau, row.number("out.tau"), 1e-9) << row.id();
        const double most = 50; // beyond what a row has
        const Segment direct{Vec3(0, 0, 0), Vec3(0, 0, 0) - sun * (2 * height / -sun.z)};
        passed.compare(row, std::exp(-scene.optical_depth(direct, most)),
                       row.number("out.T_direct"), 1e-4);
        // The eye stands a little off the face by which the light leaves.
        const Vec3 exit(0, 0, leaves.z > 0 ? height : 0);
        const Vec3 eye = exit + leaves * 1e-3;
        const FrontToBack cast = lit.along({eye, eye - leaves * (2 * height / std::abs(leaves.z))});
        // An opaque slab leaves out what passes a thousandth, all of the light of thick ones from
        // behind.
        if (leaves.z > 0 || cast.opacity < 0.999)
            light.compare(row, cast.light.g, row.number("out.L"), 1e-3);
    }
}

/// A ball of voxels, its surface blurred over a step, in m times 1000.
Volume ball(const test::OracleRow& row, int nodes) {
    const double radius = 1000 * row.number("in.R");
    const double spacing = 2 * radius / (nodes - 3), middle = (nodes - 1) / 2.0;
    std::vector<float> values;
    for (int k = 0; k < nodes; ++k)
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i) {
                const double away = (Vec3(i, j, k) - Vec3(middle)).length();
                values.push_back(
                    static_cast<float>(std::clamp(radius / spacing - away + 0.5, 0.0, 1.0)));
            }
    VolumeSpec spec = cloud_of(row);
    spec.voxels.spacing = Vec3(spacing);
    spec.voxels.origin = row.vector("in.C") * 1000 - Vec3(spacing * middle);
    return {spec, VoxelGrid({nodes, nodes, nodes}, std::move(values)), Job{}};
}

TEST(ScatterSphere, AgreesWithOracleUpToItsVoxels) {
    const test::OracleTable table("scatter_sphere");
    test::WorstError light("L"), passed("T_view"), depth("tau_d");
    constexpr int nodes = 97;
    double sum = 0;
    for (const auto& row : table) {
        std::vector<Volume> volumes;
        volumes.push_back(ball(row, nodes));
        const SceneVolumes scene(std::move(volumes));
        const LitVolumes lit(scene, sun_of(row));
        const Vec3 eye = row.vector("in.O") * 1000, way = row.unit("in.w");
        const double begin = 1000 * row.number("out.s0"), end = 1000 * row.number("out.s1");
        const Segment view{eye, eye + way * (begin + end)};
        const double chord = row.number("in.sigma") * (end - begin) / 1000;
        EXPECT_NEAR(scene.optical_depth(view, 100), chord, 0.02 * chord) << row.id();
        passed.compare(row, std::exp(-chord), row.number("out.T_view"), 1e-9);
        const Vec3 middle = row.vector("in.C") * 1000, across(0, 0, 2000 * row.number("in.R"));
        depth.compare(row, scene.optical_depth({middle - across, middle + across}, 100),
                      row.number("out.tau_d"), 5e-3);
        // Dense balls are lit in a skin of few voxels, and the surface lies within one.
        light.compare(row, lit.along(view).light.g, row.number("out.L"),
                      0.01 + row.number("out.tau_d") / (nodes - 3));
        sum += std::abs(lit.along(view).light.g / row.number("out.L") - 1);
    }
    EXPECT_LT(sum / static_cast<double>(table.size()), 0.015);
}

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
