#include "tests/bench/panel_benchmark.h"

#include "tests/bench/equal_error.h"
#include "tests/bench/panel_methods.h"
#include "tests/bench/penumbra_picture.h"
#include "tests/bench/progress.h"
#include "tests/bench/scenes.h"
#include <fmt/format.h>

namespace keiko::bench {
namespace {

using Panels = std::vector<PolygonLight>;

constexpr double wanted = 1e-3;

/// More and more strata a side of each panel.
std::vector<Cost> ladder(const PenumbraScene& scene, const Panels& panels, const Shares& truth) {
    constexpr int most = 64;
    std::vector<Cost> costs;
    for (int side = 2; side <= most; side *= 2) {
        const Shares sampled = fastest([&] { return by_samples(scene, panels, side); });
        costs.push_back({double(side) * side, rms(sampled, truth), us_a_point(sampled)});
    }
    return costs;
}

/// The cheapest picture with no more than the wanted error, or as near as pictures weigh panels.
Cost picture_cost(const PenumbraPicture& picture, const Panels& panels, double mean,
                  const Shares& truth) {
    LightRig rig;
    rig.sources.assign(panels.begin(), panels.end());
    constexpr double least = wanted / 100;
    for (double light_error = 30 * wanted;; light_error /= 2) {
        const auto render = [&] { return picture.render(rig, mean, light_error); };
        const double off = rms(render(), truth);
        if (off <= wanted || light_error <= least)
            return {.error = off, .us = us_a_point(fastest(render))};
    }
}

void add_scene(const SceneFile& file, const PanelOptions& options, Table& table) {
    constexpr double clearance = 0.02;
    constexpr double exact = 1e-6;
    PenumbraScene scene(file.name, file.load(), clearance, 1, options.points);
    const Panels panels = panels_behind(scene);
    const PenumbraPicture picture(scene, options.width, options.points);
    const Shares truth = by_lines(scene, panels, exact);
    const Cost keiko = picture_cost(picture, panels, mean_unhidden(scene, panels), truth);
    const Cost rays = cost_at(ladder(scene, panels, truth), keiko.error);
    table.rows.push_back({scene.name, fmt::format("{:.2g}", keiko.error), digits(keiko.us),
                          digits(rays.us), digits(rays.rays), digits(rays.us / keiko.us)});
}

} // namespace

Table run_panel_benchmark(const PanelOptions& options) {
    Table table{.head = {"picture", "RMS", "Keiko us", "rays us", "rays a panel", "ratio"}};
    const auto names =
        options.scenes.empty() ? std::vector<std::string>{"hood", "concept-car"} : options.scenes;
    for (const SceneFile& file : chosen_scenes(names)) {
        tell(file.name, file.present() ? "panels" : "skipped, its file is not there");
        if (file.present()) add_scene(file, options, table);
    }
    return table;
}

} // namespace keiko::bench
