#include "tests/bench/command_line.h"

#include "tests/support/paths.h"
#include <CLI/CLI.hpp>

#include <filesystem>

namespace keiko::bench {
namespace {

CLI::Option* add_markdown(CLI::App& command, std::filesystem::path& page) {
    return command
        .add_option("--markdown", page, "page to put the tables into, between its markers")
        ->check(CLI::ExistingFile);
}

void add_trace(CLI::App& app, TraceOptions& options) {
    CLI::App* trace = app.add_subcommand("trace", "rays against Keiko and its peers (the default)");
    trace->add_option("--scene", options.scenes, "scene names or model files [all]");
    trace->add_option("--rays", options.rays, "rays of each class")
        ->check(CLI::Range(16, 100000000))
        ->capture_default_str();
    trace->add_option("--slow-rays", options.slow_rays, "the same for OpenCASCADE")
        ->check(CLI::Range(1, 100000000))
        ->capture_default_str();
    trace->add_option("--rounds", options.rounds, "interleaved rounds; medians are taken")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    trace->add_option("--finest", options.finest, "one more mesh, of this deflection in mm")
        ->check(CLI::Range(1e-6, 1e3));
    trace->add_option("--most-triangles", options.most_triangles, "of the per-span grid")
        ->capture_default_str();
    // Reported now, not after ten minutes.
    const auto in_folder = [](const std::string& file) {
        const auto folder = std::filesystem::absolute(file).parent_path();
        return std::filesystem::is_directory(folder) ? std::string()
                                                     : folder.string() + " is not a folder";
    };
    trace->add_option("--json", options.json, "file to write all numbers to")->check(in_folder);
    trace->add_flag("--alone", options.alone, "Keiko without its peers, and its rates only");
    add_markdown(*trace, options.markdown)->excludes("--alone");
}

void add_load(CLI::App& app, LoadOptions& options) {
    CLI::App* load = app.add_subcommand("load", "loading model files beside OpenCASCADE's reading");
    load->add_option("FILE", options.files, "model files [the large ones of ../shared/models]")
        ->check(CLI::ExistingFile);
    load->add_option("--rounds", options.rounds, "interleaved rounds; the least time counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_markdown(*load, options.markdown);
}

void add_lights(CLI::App& app, LightsOptions& options) {
    CLI::App* lights = app.add_subcommand(
        "lights", "the smallest defects seen under a point light, parallel light and tubes");
    lights->add_option("-o,--output", options.output, "PNG file of dents under the three");
    add_markdown(*lights, options.markdown);
}

void add_shafts(CLI::App& app, ShaftsOptions& options) {
    CLI::App* shafts = app.add_subcommand(
        "shafts", "light shafts by visible intervals beside marching, at the same error");
    shafts->add_option("--rays", options.rays, "rays that are marched")
        ->check(CLI::Range(16, 3072))
        ->capture_default_str();
    shafts->add_option("--plot", options.plot, "SVG file of cost by lamps and by patches");
    shafts->add_option(
        "-o,--output", options.output,
        "PNG file of a cut shaft with the parts of one ray that are lit; nothing else "
        "is done");
    add_markdown(*shafts, options.markdown);
}

void add_penumbra(CLI::App& app, PenumbraOptions& options) {
    CLI::App* penumbra = app.add_subcommand(
        "penumbra", "penumbrae by exact intervals beside ray casting at equal error");
    penumbra->add_option("--scene", options.scenes, "scene names or model files [hood, teapot]");
    penumbra->add_option("--points", options.points, "lit points of each scene")
        ->check(CLI::Range(10, 10000000))
        ->capture_default_str();
    penumbra->add_option("--width", options.width, "of the pictures, pixels")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    penumbra
        ->add_option("--probes", options.probes, "only probe each lamp's intervals by so many rays")
        ->check(CLI::Range(1, 1000000));
    penumbra->add_option("--plot", options.plot, "SVG file of cost by lamps and by patches");
    add_markdown(*penumbra, options.markdown);
}

void add_panels(CLI::App& app, PanelOptions& options) {
    CLI::App* panels = app.add_subcommand(
        "panels", "light of panels by visible lines beside stratified sampling at equal error");
    panels->add_option("--scene", options.scenes, "scene names or model files [hood, concept-car]");
    panels->add_option("--points", options.points, "lit points of each scene")
        ->check(CLI::Range(10, 10000000))
        ->capture_default_str();
    panels->add_option("--width", options.width, "of the pictures, pixels")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    add_markdown(*panels, options.markdown);
}

void add_stripes(CLI::App& app, StripeOptions& options) {
    CLI::App* stripes = app.add_subcommand(
        "stripes", "stripes from one ray a pixel against 1024 rays and supersampling");
    stripes->add_option("--scene", options.scenes,
                        "scene names or model files [hood, car-front-fender]");
    stripes->add_option("--width", options.width, "of the pictures, pixels")
        ->check(CLI::Range(16, 4096))
        ->capture_default_str();
    stripes->add_option("--pictures", options.pictures, "folder to put the pictures into")
        ->check(CLI::ExistingDirectory);
    add_markdown(*stripes, options.markdown);
}

void add_frames(CLI::App& app, FrameOptions& options) {
    CLI::App* frames =
        app.add_subcommand("frames", "pictures of the concept car, with and without penumbrae");
    frames->add_option("--width", options.width, "pixels")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    add_markdown(*frames, options.markdown);
}

void add_raster(CLI::App& app, RasterOptions& options) {
    CLI::App* raster =
        app.add_subcommand("raster", "the visible triangles of the concept car's mesh");
    raster->add_option("--mesh", options.deviation, "mm that the surface may leave it by")
        ->check(CLI::Range(1e-6, 1e6))
        ->capture_default_str();
    raster->add_option("--width", options.width, "of the picture, pixels")
        ->check(CLI::Range(16, 16384))
        ->capture_default_str();
    add_markdown(*raster, options.markdown);
}

void add_hidden(CLI::App& app, HiddenOptions& options) {
    CLI::App* hidden = app.add_subcommand(
        "hidden", "hidden surfaces and shadows of spheres that pierce each other, by all classes");
    hidden->add_option("--plot", options.plot, "SVG file of cost and memory");
    hidden->add_flag("--brief", options.brief, "smallest sizes alone: whether it runs");
    add_markdown(*hidden, options.markdown);
}

void add_inspect(CLI::App& app, InspectBenchmarkOptions& options) {
    CLI::App* inspect = app.add_subcommand(
        "inspect", "processor time of keiko inspect by stage, beside OpenCASCADE's meshing");
    inspect->add_option("FILE", options.files, "model files [those of the tracked table]")
        ->check(CLI::ExistingFile);
    inspect->add_option("--rig", options.rig, "rig file for all of them [lamps are placed]")
        ->check(CLI::ExistingFile);
    add_markdown(*inspect, options.markdown);
}

} // namespace

Command parse_command_line(int argc, char** argv) {
    Command command;
    CLI::App app("Keiko's benchmarks", "./dev bench");
    app.require_subcommand(1);
    app.footer("Without a group: trace. ./dev bench trace --help tells its options.");
    add_trace(app, command.trace);
    add_load(app, command.load);
    add_lights(app, command.lights);
    add_shafts(app, command.shafts);
    add_penumbra(app, command.penumbra);
    add_panels(app, command.panels);
    add_stripes(app, command.stripes);
    add_frames(app, command.frames);
    add_inspect(app, command.inspect);
    add_raster(app, command.raster);
    add_hidden(app, command.hidden);
    CLI::App* picture = app.add_subcommand(
        "picture", "the same stripes from meshes and from the surface, side by side");
    command.picture.output = test::repository("docs/images/mesh-or-surface.png");
    picture->add_option("-o,--output", command.picture.output,
                        "PNG file to write [docs/images/mesh-or-surface.png]");

    std::vector<std::string> words(argv + 1, argv + argc);
    const bool asks_help = !words.empty() && (words[0] == "--help" || words[0] == "-h");
    if (!asks_help && (words.empty() || words[0].starts_with("-")))
        words.insert(words.begin(), "trace");
    std::vector<std::string> reversed(words.rbegin(), words.rend()); // as CLI11 wants them
    try {
        app.parse(reversed);
    } catch (const CLI::ParseError& error) {
        command.group = Group::help;
        command.exit_code = app.exit(error) == 0 ? 0 : 2;
        return command;
    }
    command.group = app.got_subcommand("picture")    ? Group::picture
                    : app.got_subcommand("load")     ? Group::load
                    : app.got_subcommand("lights")   ? Group::lights
                    : app.got_subcommand("shafts")   ? Group::shafts
                    : app.got_subcommand("penumbra") ? Group::penumbra
                    : app.got_subcommand("panels")   ? Group::panels
                    : app.got_subcommand("stripes")  ? Group::stripes
                    : app.got_subcommand("frames")   ? Group::frames
                    : app.got_subcommand("inspect")  ? Group::inspect
                    : app.got_subcommand("raster")   ? Group::raster
                    : app.got_subcommand("hidden")   ? Group::hidden
                                                     : Group::trace;
    return command;
}

} // namespace keiko::bench
