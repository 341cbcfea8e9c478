#include "keiko/base/output_file.h"
#include "keiko/cli/commands.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/output_place.h"
#include "keiko/cli/scene_options.h"

#include <cmath>
#include <iostream>
#include <map>
#include <memory>

namespace keiko::cli {
namespace {

struct LinesArguments {
    SceneArguments scene;
    LinesOptions options;
    std::filesystem::path rig, output, csv;
};

const std::map<std::string, LineLook> looks{{"reflection", LineLook::reflection},
                                            {"highlight", LineLook::highlight},
                                            {"isophote", LineLook::isophote}};

void print_summary(const LineList& list, const std::filesystem::path& output) {
    std::size_t count = 0, unproved = 0;
    double length = 0;
    for (const ViewLines& view : list.views)
        for (const SurfaceLine& line : view.lines) {
            ++count;
            unproved += line.line.proved ? 0 : 1;
            length += length_of(line.line);
        }
    std::cout << count << " pieces of " << name_of(list.look) << " lines, " << std::llround(length)
              << " mm, " << unproved << " of them not proved; see " << output.string() << "\n";
}

int lines(LinesArguments arguments, const Job& job) {
    require_place_for_file(arguments.output);
    if (!arguments.csv.empty()) require_place_for_file(arguments.csv);
    require_view_names(arguments.options.views);
    if (!arguments.rig.empty()) {
        arguments.options.rig = arguments.rig;
        read_rig(arguments.rig); // a misspelt key is told before the long work
    }
    const Scene scene = arguments.scene.open(job);
    const LineList list = find_lines(scene, arguments.options, job);
    write_text_file(arguments.output, lines_json(list, scene.model));
    if (!arguments.csv.empty()) write_text_file(arguments.csv, lines_csv(list, scene.model));
    print_summary(list, arguments.output);
    return exit_pass;
}

} // namespace

void add_lines(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<LinesArguments>();
    CLI::App& command = *app.add_subcommand(
        "lines", "find the reflection lines of lamps, highlight lines or isophotes as curves");
    arguments->scene.add_to(command, "MODEL|SCENE");
    command.add_option("--rig", arguments->rig, "rig file [the scene's own]");
    command
        .add_option("--view", arguments->options.views,
                    "view by name, or auto; may repeat [the scene's own, or auto]")
        ->allow_extra_args(false);
    command
        .add_option("--look", arguments->options.lines.look,
                    "reflection, highlight or isophote [reflection]")
        ->transform(CLI::CheckedTransformer(looks))
        ->option_text("NAME");
    command
        .add_option("--chord", arguments->options.lines.lines.chord_error,
                    "mm between a curve and the chords of its points")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command.add_option("-o,--output", arguments->output, "JSON file to write")->required();
    command.add_option("--csv", arguments->csv, "CSV file of the points to write as well");
    command.footer(
        "Example: keiko lines hood.step --rig lightrigs/tunnel-12.toml -o hood-lines.json");
    session.add_command(command, [arguments](const Job& job) { return lines(*arguments, job); });
}

} // namespace keiko::cli
