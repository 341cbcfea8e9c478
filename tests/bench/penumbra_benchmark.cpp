#include "tests/bench/penumbra_benchmark.h"

#include "tests/bench/equal_error.h"
#include "tests/bench/log_plot.h"
#include "tests/bench/penumbra_methods.h"
#include "tests/bench/penumbra_picture.h"
#include "tests/bench/progress.h"
#include "tests/bench/scenes.h"
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace keiko::bench {
namespace {

constexpr int lamps = 12;
constexpr std::array errors{1e-3, 1e-5};

/// More and more strata along each lamp.
std::vector<Cost> ladder(const PenumbraScene& scene, Emitter emitter, int across,
                         const Shares& truth) {
    constexpr int first = 4, most = 1024; ///< rays a lamp
    std::vector<Cost> costs;
    for (int rays = first; rays <= most; rays *= 2) {
        if (rays < across) continue;
        const Strata strata{rays / across, across};
        const Shares sampled =
            fastest([&] { return by_samples(scene, scene.row, emitter, strata); });
        costs.push_back({double(rays), rms(sampled, truth), us_a_point(sampled)});
    }
    return costs;
}

std::vector<std::string> row_of(const PenumbraScene& scene, const char* emitter, double error,
                                double us, const Cost& rays) {
    return {scene.name,      emitter,           fmt::format("{:.2g}", error), digits(us),
            digits(rays.us), digits(rays.rays), digits(rays.us / us)};
}

void add_axis(const PenumbraScene& scene, Table& table) {
    const Shares exact = fastest([&] { return by_intervals(scene, scene.row); });
    const std::vector<std::vector<Cost>> ladders(1, ladder(scene, Emitter::axis, 1, exact));
    for (const double error : errors)
        table.rows.push_back(
            row_of(scene, "axis", error, us_a_point(exact), best_sampling(ladders, error)));
}

/// The cheapest tolerance with no more than this error.
double width_cost(const PenumbraScene& scene, const Shares& truth, double error) {
    for (double tolerance = 30 * error;; tolerance /= 2) {
        const Shares shares = fastest([&] { return by_width(scene, scene.row, tolerance); });
        if (rms(shares, truth) <= error) return us_a_point(shares);
    }
}

void add_width(const PenumbraScene& scene, Table& table) {
    const Shares truth = by_width(scene, scene.row, 1e-8);
    std::vector<std::vector<Cost>> ladders;
    for (const int across : {1, 2, 4})
        ladders.push_back(ladder(scene, Emitter::rectangle, across, truth));
    for (const double error : errors)
        table.rows.push_back(row_of(scene, "width", error, width_cost(scene, truth, error),
                                    best_sampling(ladders, error)));
}

/// us a point for a row of that many lamps.
double exact_cost(const PenumbraScene& scene, int count) {
    const CPlane row = scene.row_of(count);
    return us_a_point(fastest([&] { return by_intervals(scene, row); }));
}

/// The cheapest picture whose receivers are within `error`, or as near as the rule over the width
/// lets them be.
Cost picture_cost(const PenumbraPicture& picture, Emitter emitter, const Shares& truth,
                  double error) {
    const double least = error / 100;
    for (double light_error = 30 * error;; light_error /= 1.5) {
        const auto render = [&] { return picture.render(emitter, light_error); };
        const double off = rms(render(), truth);
        if (off <= error || light_error <= least)
            return {.error = off, .us = us_a_point(fastest(render))};
    }
}

void add_picture_of(const PenumbraPicture& picture, const PenumbraScene& scene, Emitter emitter,
                    const Shares& truth, std::span<const double> wanted, Table& table) {
    const bool axis = emitter == Emitter::axis;
    std::vector<std::vector<Cost>> ladders;
    const Shares sampled_truth = axis ? truth : by_width(scene, scene.row, 1e-8);
    for (const int across : axis ? std::vector{1} : std::vector{1, 2, 4})
        ladders.push_back(
            ladder(scene, axis ? Emitter::axis : Emitter::rectangle, across, sampled_truth));
    for (const double error : wanted) {
        const Cost cost = picture_cost(picture, emitter, truth, error);
        table.rows.push_back(row_of(scene, axis ? "axis" : "width", cost.error, cost.us,
                                    best_sampling(ladders, cost.error)));
    }
}

void add_pictures(PenumbraScene& scene, const PenumbraOptions& options, Table& table) {
    const PenumbraPicture picture(scene, options.width, options.points);
    add_picture_of(picture, scene, Emitter::axis, by_intervals(scene, scene.row), errors, table);
    // Pictures weigh widths to 3e-3 of a lamp at best.
    add_picture_of(picture, scene, Emitter::tube, by_width(scene, scene.row, 1e-8, Emitter::tube),
                   std::span(errors).first(1), table);
}

void add_lamps(const PenumbraScene& scene, Table& table, LogPlot& plot) {
    LogPlot::Curve curve{scene.name};
    std::vector<std::string> cells{scene.name};
    for (const int count : {1, 12, 48}) {
        const double us = exact_cost(scene, count);
        curve.points.push_back({double(count), us});
        cells.push_back(digits(us));
    }
    table.rows.push_back(std::move(cells));
    plot.curves.push_back(std::move(curve));
}

void add_patches(std::size_t points, Table& table, LogPlot& plot) {
    constexpr double clearance = 0.3;
    LogPlot::Curve curve{"wavy sheet"};
    for (const auto& [along, across] :
         {std::array{8, 4}, {16, 8}, {32, 16}, {64, 32}, {128, 64}, {200, 100}}) {
        tell("wavy sheet", std::to_string(along * across) + " patches");
        const PenumbraScene scene("wavy sheet", wavy_sheet(along, across), clearance, lamps,
                                  points);
        const double us = exact_cost(scene, lamps);
        curve.points.push_back({double(along * across), us});
        table.rows.push_back({std::to_string(along * across), digits(us)});
    }
    plot.curves.push_back(std::move(curve));
}

void add_wrong(const PenumbraScene& scene, int probes, Table& table) {
    const WrongLamps count = wrong_lamps(scene, scene.row, probes);
    table.rows.push_back({scene.name, std::to_string(count.lamps), std::to_string(count.probes),
                          std::to_string(count.uncertain), std::to_string(count.wrong)});
}

} // namespace

PenumbraTables run_penumbra_benchmark(const PenumbraOptions& options) {
    constexpr double clearance = 0.05;
    PenumbraTables tables{
        .equal_error = {.head = {"scene", "of a lamp", "RMS", "Keiko us", "rays us", "rays a lamp",
                                 "ratio"},
                        .left = 2},
        .pictures = {.head = {"picture", "of a lamp", "RMS", "Keiko us", "rays us", "rays a lamp",
                              "ratio"},
                     .left = 2},
        .by_lamps = {.head = {"scene", "1 lamp us", "12 lamps us", "48 lamps us"}},
        .by_patches = {.head = {"patches", "12 lamps us"}, .left = 0},
        .wrong = {.head = {"scene", "lamps", "probes", "uncertain", "wrong"}}};
    LogPlot lamp_plot{.x = "lamps", .y = "µs a point"};
    LogPlot patch_plot{.x = "patches", .y = "µs a point, 12 lamps"};
    const auto names =
        options.scenes.empty() ? std::vector<std::string>{"hood", "teapot"} : options.scenes;
    for (const SceneFile& file : chosen_scenes(names)) {
        if (!file.present()) {
            tell(file.name, "skipped, its file is not there");
            continue;
        }
        tell(file.name, "penumbrae");
        PenumbraScene scene(file.name, file.load(), clearance, lamps, options.points);
        if (options.probes > 0) {
            add_wrong(scene, options.probes, tables.wrong);
            continue;
        }
        add_axis(scene, tables.equal_error);
        add_width(scene, tables.equal_error);
        add_lamps(scene, tables.by_lamps, lamp_plot);
        add_pictures(scene, options, tables.pictures);
    }
    if (options.probes > 0) return tables;
    add_patches(options.points, tables.by_patches, patch_plot);
    if (!options.plot.empty()) write_svg(options.plot, {lamp_plot, patch_plot});
    return tables;
}

} // namespace keiko::bench
