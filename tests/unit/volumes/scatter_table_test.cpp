#include "keiko/light/fog/window_beam.h"
#include "keiko/math/quadrature.h"
#include "keiko/volumes/lit_volumes.h"

#include "tests/support/oracle.h"
#include <gtest/gtest.h>

#include <cmath>

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

/// The integral along the view ray of a row, with depths towards the sun as the uniform leg has
/// them.
double integral_along(const test::OracleRow& row, const Volume& volume) {
    const VolumeSpec& spec = volume.spec();
    const double extinction = row.number("in.sigma") / 1000;
    const Vec3 leaves = row.unit("in.v"), sun = -row.unit("in.dl");
    const double height = 1000 * row.number("in.h"), length = height / std::abs(leaves.z);
    const BeamDepths depths = BeamDepths::uniform(volume, sun, extinction);
    const Vec3 exit(0, 0, leaves.z > 0 ? height : 0);
    constexpr int panels = 50;
    double sum = 0;
    for (int panel = 0; panel < panels; ++panel)
        for (const QuadratureNode& node : gauss_legendre(16)) {
            const double s = (panel + (1 + node.x) / 2) * length / panels;
            const Vec3 place = exit - leaves * s;
            const double tau = depths((place - spec.voxels.origin) / spec.voxels.spacing);
            sum += extinction * std::exp(-extinction * s - tau) * node.weight * length / panels / 2;
        }
    return sum * row.number("in.w0") * row.number("in.E0") *
           phase(spec.scattering->phase, -sun.dot(leaves));
}

TEST(ScatterSlab, AgreesWithOracleByTheUniformLegToItsTolerance) {
    const test::OracleTable table("scatter_slab");
    test::WorstError light("L");
    for (const auto& row : table)
        light.compare(row, integral_along(row, slab(row)), row.number("out.L"), 1e-11);
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

} // namespace
} // namespace keiko
