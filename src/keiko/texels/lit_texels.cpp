#include "keiko/texels/lit_texels.h"

#include "keiko/base/parallel.h"
#include "keiko/texels/fibre_reflection.h"
#include "keiko/volumes/opacity.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double opaque = 0.999; ///< opacity beyond which nothing behind counts
constexpr double darkness = 8;   ///< optical depth that no light counts beyond

/// Run through one of the shells of a scene.
struct RunOfShell {
    std::size_t shell;
    ShellRun run;
};

std::vector<RunOfShell> runs_of(const SceneTexels& texels, const Segment& segment) {
    std::vector<RunOfShell> all;
    for (std::size_t i = 0; i < texels.shells().size(); ++i)
        for (const ShellRun& run : texels.shells()[i].runs(segment)) all.push_back({i, run});
    std::stable_sort(all.begin(), all.end(), [](const RunOfShell& a, const RunOfShell& b) {
        return a.run.begin < b.run.begin;
    });
    return all;
}

/// A run in mm from another place of its line. From where it enters a shell neighbouring rays have
/// their samples at the same depths, without rings.
ShellRun from(ShellRun run, double begin) {
    run.first += run.change * begin;
    run.begin -= begin, run.end -= begin;
    return run;
}

/// mm, the width of a ray at a distance from its begin.
double width_at(const std::optional<RayDifferentials>& spread, double t) {
    if (!spread) return 0;
    return std::max((spread->origin_dx + spread->direction_dx * t).length(),
                    (spread->origin_dy + spread->direction_dy * t).length());
}

/// The coarsest level whose voxels are no longer than a width.
int level_for(const TexelBlock& block, double width) {
    int level = 0;
    while (level < block.coarsest() && block.voxel() * (2 << level) <= width) ++level;
    return level;
}

} // namespace

LitTexels::LitTexels(const SceneTexels& texels, const LightsAt& lights, const Rgb& ambient,
                     const Job& job)
    : texels_(texels), ambient_(ambient) {
    for (const TexelShell& shell : texels.shells()) {
        const ShellLattice& lattice = shell.lattice();
        const std::vector<bool> used = shell.used_nodes();
        NodeLights nodes(used.size());
        parallel_for(nodes.size(), job, "", [&](std::size_t i) {
            if (used[i]) nodes[i] = lights((lattice.foot[i] + lattice.top[i]) / 2);
        });
        nodes_.push_back(std::move(nodes));
        highlights_.push_back(fibre_highlight_scale(shell.spec().exponent));
    }
}

std::vector<ArrivingLight> LitTexels::lights_in(std::size_t shell, const ShellPart& part,
                                                const Vec3& in_cell) const {
    const ShellLattice& lattice = texels_.shells()[shell].lattice();
    std::vector<ArrivingLight> sum;
    for (const int u : {0, 1})
        for (const int v : {0, 1}) {
            const double share = (u ? in_cell.x : 1 - in_cell.x) * (v ? in_cell.y : 1 - in_cell.y);
            const auto& node = nodes_[shell][lattice.index(part.cell_u + u, part.cell_v + v)];
            if (sum.empty()) sum.assign(node.size(), {Vec3(0), Rgb(0)});
            for (std::size_t i = 0; i < node.size(); ++i) {
                sum[i].towards += node[i].towards * share;
                sum[i].illuminance += node[i].illuminance * share;
            }
        }
    std::erase_if(sum, [](const ArrivingLight& light) { return light.illuminance == Rgb(0); });
    for (ArrivingLight& light : sum) light.towards.normalize();
    return sum;
}

Rgb LitTexels::luminance(const Seen& seen, const Vec3& fibre,
                         std::span<const ArrivingLight> lights) const {
    const TexelShell& shell = texels_.shells()[seen.shell];
    const TexelSpec& spec = shell.spec();
    const int coarser = std::min(seen.level + 1, shell.block().coarsest());
    const auto arrives = [&](const Vec3& towards) {
        const double depth =
            shell.depth_outwards(seen.part, seen.in_cell, towards, coarser, darkness);
        return depth < darkness ? std::exp(-depth) : 0;
    };
    Rgb sum;
    for (const ArrivingLight& light : lights) {
        const double diffuse = fibre_diffuse(fibre, light.towards) * fibre_diffuse_scale();
        const double specular =
            fibre_specular(fibre_cone_cosine(fibre, light.towards, seen.to_viewer), spec.exponent) *
            highlights_[seen.shell];
        sum += light.illuminance * arrives(light.towards) *
               (spec.diffuse * diffuse + spec.specular * specular);
    }
    if (ambient_ == Rgb(0)) return sum;
    return sum + ambient_ * (spec.diffuse + spec.specular) * arrives(seen.part.axes[2]);
}

void LitTexels::add_run(std::size_t number, const ShellRun& run, const Vec3& to_viewer, int level,
                        FrontToBack& sum) const {
    const TexelShell& shell = texels_.shells()[number];
    std::optional<std::vector<ArrivingLight>> lights;
    shell.each_sample(run, level, [&](const Vec3& at, const Fibres& fibres, double step) {
        if (!lights) lights = lights_in(number, *run.part, run.at((run.begin + run.end) / 2));
        const double length = fibres.direction.length();
        const Vec3 fibre = length > 0 ? fibres.direction / length : run.part->axes[2];
        sum.add(luminance({number, *run.part, at, to_viewer, level}, fibre, *lights),
                opacity_of_depth(fibres.extinction * step));
        return sum.opacity <= opaque;
    });
}

std::vector<TexelLayer> LitTexels::along(const Segment& segment,
                                         const std::optional<RayDifferentials>& spread) const {
    const Vec3 to_viewer = (segment.a - segment.b).normalized();
    std::vector<TexelLayer> layers;
    for (const auto& [shell, run] : runs_of(texels_, segment)) {
        const TexelBlock& block = texels_.shells()[shell].block();
        if (layers.empty() || run.begin > layers.back().end + block.voxel())
            layers.push_back({run.begin, run.end, {}});
        TexelLayer& layer = layers.back();
        layer.end = std::max(layer.end, run.end);
        add_run(shell, from(run, layer.begin), to_viewer,
                level_for(block, width_at(spread, run.begin)), layer.sum);
        if (layer.sum.opacity > opaque) break;
    }
    return layers;
}

} // namespace keiko
