#include "keiko/base/memory.h"

#include "tests/bench/command_line.h"
#include "tests/bench/cut_shaft.h"
#include "tests/bench/hidden_benchmark.h"
#include "tests/bench/markdown.h"
#include "tests/bench/mesh_or_surface.h"
#include "tests/bench/peer_rays.h"
#include "tests/bench/raster_benchmark.h"
#include "tests/bench/results_json.h"
#include "tests/bench/shadow_benchmark.h"
#include "tests/bench/shafts_benchmark.h"
#include "tests/bench/targets.h"
#include "tests/bench/three_lights.h"
#include "tests/bench/trace_benchmark.h"
#include "tests/bench/trace_tables.h"

#include <cstdio>
#include <exception>

namespace {

using namespace keiko::bench;

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
}

void trace(const TraceOptions& options) {
    const TraceResults results = run_trace_benchmark(options);
    print(conditions_of(results) + "\n");
    for (const std::string& name : results.skipped)
        print("skipped, its file is not there: " + name + "\n");
    for (const SceneResult& scene : results.scenes)
        print("\n" + title_of(scene) + "\n\n" + text_of(cost_table(scene)) + "\n" +
              text_of(rate_table(scene)));
    if (!options.alone) print("\ntargets\n\n" + text_of(target_table(results)));
    if (!options.json.empty()) write_json(options.json, results);
    if (!options.markdown.empty()) update_page(options.markdown, "trace", markdown_of(results));
}

void load(const LoadOptions& options) {
    const std::string table = load_table(run_load_benchmark(options));
    print(table);
    if (!options.markdown.empty()) update_page(options.markdown, "load", table);
}

void lights(const LightsOptions& options) {
    if (!options.output.empty()) draw_three_lights(options.output);
    const Table lines = seen_lines_table(), table = three_lights_table();
    print(text_of(lines) + "\n" + text_of(table));
    if (!options.markdown.empty())
        update_page(options.markdown, "lights", markdown_of(table) + "\n" + markdown_of(lines));
}

void shafts(const ShaftsOptions& options) {
    if (!options.output.empty()) return draw_cut_shaft(options.output);
    const std::vector<ShaftCost> costs = run_shafts_benchmark(options.rays);
    const Table table = shafts_table(costs);
    print(text_of(table));
    if (!options.plot.empty()) write_svg(options.plot, shafts_plots(costs));
    if (!options.markdown.empty()) update_page(options.markdown, "shafts", markdown_of(table));
}

void penumbra(const PenumbraOptions& options) {
    const PenumbraTables tables = run_penumbra_benchmark(options);
    std::string page;
    for (const Table* table : {&tables.equal_error, &tables.pictures, &tables.by_lamps,
                               &tables.by_patches, &tables.wrong}) {
        if (table->rows.empty()) continue;
        print(text_of(*table) + "\n");
        page += markdown_of(*table) + "\n";
    }
    if (!options.markdown.empty())
        update_page(options.markdown, options.probes > 0 ? "wrong" : "penumbra", page);
}

void panels(const PanelOptions& options) {
    const Table table = run_panel_benchmark(options);
    print(text_of(table));
    if (!options.markdown.empty()) update_page(options.markdown, "panels", markdown_of(table));
}

void stripes(const StripeOptions& options) {
    const Table table = run_stripe_benchmark(options);
    print(text_of(table));
    if (!options.markdown.empty()) update_page(options.markdown, "stripes", markdown_of(table));
}

void frames(const FrameOptions& options) {
    const Table table = run_frame_benchmark(options);
    print(text_of(table));
    if (!options.markdown.empty()) update_page(options.markdown, "frames", markdown_of(table));
}

void inspect(const InspectBenchmarkOptions& options) {
    const Table table = run_inspect_benchmark(options);
    print(text_of(table));
    if (!options.markdown.empty()) update_page(options.markdown, "inspect", markdown_of(table));
}

void raster(const RasterOptions& options) {
    const Table table = run_raster_benchmark(options);
    print(text_of(table));
    if (!options.markdown.empty()) update_page(options.markdown, "raster", markdown_of(table));
}

void hidden(const HiddenOptions& options) {
    std::string page;
    const auto add = [&](const Table& table) {
        print(text_of(table) + "\n");
        page += markdown_of(table) + "\n";
    };
    const std::vector<HiddenSeries> series = run_hidden_benchmark(options);
    add(hidden_table(series));
    add(peer_ray_table(options.brief));
    add(thread_table(options.brief));
    add(shadow_table(options.brief));
    if (!options.plot.empty()) write_svg(options.plot, hidden_plots(series));
    if (!options.markdown.empty()) update_page(options.markdown, "hidden", page);
}

} // namespace

int main(int argc, char** argv) {
    keiko::keep_freed_memory(); // as keiko does
    const Command command = parse_command_line(argc, argv);
    try {
        switch (command.group) {
            case Group::trace:
                trace(command.trace);
                return 0;
            case Group::picture:
                draw_mesh_or_surface(command.picture.output);
                return 0;
            case Group::load:
                load(command.load);
                return 0;
            case Group::lights:
                lights(command.lights);
                return 0;
            case Group::shafts:
                shafts(command.shafts);
                return 0;
            case Group::penumbra:
                penumbra(command.penumbra);
                return 0;
            case Group::panels:
                panels(command.panels);
                return 0;
            case Group::stripes:
                stripes(command.stripes);
                return 0;
            case Group::frames:
                frames(command.frames);
                return 0;
            case Group::inspect:
                inspect(command.inspect);
                return 0;
            case Group::raster:
                raster(command.raster);
                return 0;
            case Group::hidden:
                hidden(command.hidden);
                return 0;
            case Group::help:
                return command.exit_code;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "keiko_bench: %s\n", error.what());
    }
    return 2;
}
