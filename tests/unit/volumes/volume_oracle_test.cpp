// Tables of volumes, with voxels in double precision and their samples.
#include "keiko/light/luminance/front_to_back.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/math/quadrature.h"
#include "keiko/volumes/lit_volumes.h"
#include "keiko/volumes/opacity.h"
#include "keiko/volumes/volume_shading.h"

#include "tests/support/oracle.h"
#include "tests/unit/volumes/wave_voxels.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

VolumeShading shading_of(const test::OracleRow& row) {
    return {.light = row.unit("in.Lt"),
            .luminance = row.number("in.I"),
            .ambient = row.number("in.ka"),
            .diffuse = row.number("in.kd"),
            .specular = row.number("in.ks"),
            .exponent = row.number("in.n"),
            .cue = row.number("in.k1"),
            .cue_per_length = row.number("in.k2")};
}

RegionOpacity region_of(const test::OracleRow& row) {
    return {.low = row.number("in.f0"),
            .high = row.number("in.f1"),
            .opacity_low = row.number("in.a0"),
            .opacity_high = row.number("in.a1")};
}

TEST(TrilinearGradient, AgreesWithOracle) {
    const test::OracleTable table("trilinear_gradient");
    test::WorstError value("val"), gradient("grad"), opacity("alpha"), shade("shade");
    for (const auto& row : table) {
        const VoxelGridOf<double> grid({3, 3, 3}, row.list("in.f"));
        const Vec3 place(row.number("in.px"), row.number("in.py"), row.number("in.pz"));
        value.compare(row, grid.value(place), row.number("out.val"), 1e-12);
        const Vec3 slope = grid.node_gradient(1, 1, 1), expected = row.vector("out.grad");
        for (unsigned axis = 0; axis < 3; ++axis)
            gradient.compare(row, slope[axis], expected[axis], 1e-12);
        opacity.compare(row, region_opacity(region_of(row), grid.value(Vec3(1)), slope.length()),
                        row.number("out.alpha"), 1e-11);
        const VolumeShading shading = shading_of(row);
        // The table's normal points along the gradient.
        const ShadingTerms terms =
            shading_terms(shading, -volume_normal(slope), *shading.light, row.unit("in.Vw"));
        shade.compare(row, shaded_luminance(shading, terms, Rgb(1), row.number("in.d")).g,
                      row.number("out.shade"), 1e-11);
    }
}

TEST(VolumeEmission, AgreesWithOracleAtItsSamples) {
    const test::OracleTable table("volume_emission");
    test::WorstError light("C"), opacity("A"), seen("L"), stopped("C_stop");
    for (const auto& row : table) {
        const auto grid = test::wave_voxels<double>(row);
        const test::WaveRay ray(row, grid.nodes());
        EXPECT_NEAR(ray.begin, row.number("out.t0"), 1e-9) << row.id();
        EXPECT_NEAR(ray.end, row.number("out.t1"), 1e-9) << row.id();
        ASSERT_EQ(ray.count, row.integer("out.ns")) << row.id();
        FrontToBack all, first;
        int used = 0;
        for (int m = 0; m < ray.count; ++m) {
            const double x = ray.inside(ray.t(m)) ? grid.value(ray.place(ray.t(m))) : 0;
            const Rgb own(row.number("in.i0") + row.number("in.i1") * x);
            const double alpha = opacity_of_depth(row.number("in.kap") * x * ray.step);
            if (first.opacity <= row.number("in.stop")) first.add(own, alpha), ++used;
            all.add(own, alpha);
        }
        EXPECT_EQ(used, row.integer("out.n_stop")) << row.id();
        stopped.compare(row, first.light.g, row.number("out.C_stop"), 1e-11);
        light.compare(row, all.light.g, row.number("out.C"), 1e-11);
        opacity.compare(row, all.opacity, row.number("out.A"), 1e-11);
        all.add(Rgb(row.number("in.bg")), 1);
        seen.compare(row, all.light.g, row.number("out.L"), 1e-11);
    }
}

/// The volume of a row, whose extinction and emission are linear in the value.
VolumeSpec emission_of(const test::OracleRow& row) {
    VolumeSpec spec;
    spec.voxels = test::wave_files(row);
    spec.extinction.points = {{0, 0}, {1, per_metre(row.number("in.kap"))}};
    const Rgb at_0(row.number("in.i0"));
    spec.emits.points = {{0, at_0}, {1, at_0 + Rgb(row.number("in.i1"))}};
    return spec;
}

TEST(VolumeEmission, ApproachesTheExactLightByShorterSteps) {
    const test::OracleTable table("volume_emission");
    test::WorstError depth("tau_exact"), passed("T_exact"), light("L_exact");
    for (const auto& row : table) {
        VolumeSpec spec = emission_of(row);
        spec.step = row.number("in.sp") / 64;
        std::vector<Volume> volumes;
        volumes.emplace_back(spec, test::wave_voxels<float>(row), Job{});
        const Vec3 origin = row.vector("in.O");
        const Segment way{origin, origin + row.unit("in.dir") * 1000};
        const SceneVolumes scene(std::move(volumes));
        FrontToBack sum = LitVolumes(scene, LightRig()).along(way);
        const bool ended = sum.opacity > 0.999; // where the rest is left out
        if (!ended) {
            passed.compare(row, 1 - sum.opacity, row.number("out.T_exact"), 1e-4);
            depth.compare(row, depth_of_opacity(sum.opacity), row.number("out.tau_exact"), 1e-4);
        }
        sum.add(Rgb(row.number("in.bg")), 1);
        light.compare(row, sum.light.g, row.number("out.L_exact"), ended ? 2e-3 : 1e-4);
    }
}

/// Opacity of a node of a row, by contour or region as it says.
double node_opacity(const test::OracleRow& row, double value, double gradient) {
    if (row.text("in.mode") == "region") return region_opacity(region_of(row), value, gradient);
    const ContourOpacity contour{.value = row.number("in.fv"),
                                 .thickness = row.number("in.rr"),
                                 .opacity = row.number("in.av")};
    return contour_opacity(contour, value, gradient);
}

TEST(VolumeLevoy, AgreesWithOracleAtItsSamples) {
    const test::OracleTable table("volume_levoy");
    test::WorstError light("C"), opacity("A"), seen("L"), node_value("node_f"),
        node_alpha("node_alpha"), node_bracket("node_bracket");
    for (const auto& row : table) {
        const auto grid = test::wave_voxels<double>(row);
        const test::WaveRay ray(row, grid.nodes());
        ASSERT_EQ(ray.count, row.integer("out.ns")) << row.id();
        const VolumeShading shading = shading_of(row);
        const auto terms_at = [&](std::size_t x, std::size_t y, std::size_t z) {
            return shading_terms(shading, volume_normal(grid.node_gradient(x, y, z)),
                                 *shading.light, -ray.direction);
        };
        const auto alpha_at = [&](std::size_t x, std::size_t y, std::size_t z) {
            return node_opacity(row, grid.values()[grid.index(x, y, z)],
                                grid.node_gradient(x, y, z).length());
        };
        FrontToBack sum;
        for (int m = 0; m < ray.count; ++m) {
            if (!ray.inside(ray.t(m))) continue;
            const GridCell cell = grid_cell(ray.place(ray.t(m)), grid.nodes());
            const auto& n = cell.node;
            const auto mean = [&](const auto& at) {
                return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
                    return at(n[0] + x, n[1] + y, n[2] + z);
                });
            };
            const ShadingTerms terms{
                mean([&](auto... node) { return terms_at(node...).diffuse; }),
                mean([&](auto... node) { return terms_at(node...).specular; })};
            sum.add(shaded_luminance(shading, terms, Rgb(1), ray.t(m)), mean(alpha_at));
        }
        light.compare(row, sum.light.g, row.number("out.C"), 1e-10);
        opacity.compare(row, sum.opacity, row.number("out.A"), 1e-10);
        sum.add(Rgb(row.number("in.bg")), 1);
        seen.compare(row, sum.light.g, row.number("out.L"), 1e-10);
        const auto at = [&](const char* name) {
            return static_cast<std::size_t>(row.integer(name));
        };
        const std::size_t i = at("in.pi"), j = at("in.pj"), k = at("in.pk");
        node_value.compare(row, grid.values()[grid.index(i, j, k)], row.number("out.node_f"),
                           1e-11);
        node_alpha.compare(row, alpha_at(i, j, k), row.number("out.node_alpha"), 1e-10);
        const ShadingTerms terms = terms_at(i, j, k);
        node_bracket.compare(row, terms.diffuse + terms.specular, row.number("out.node_bracket"),
                             1e-10);
    }
}

} // namespace
} // namespace keiko
