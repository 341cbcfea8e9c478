#include "keiko/cli/commands.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/scene_options.h"
#include "keiko/compare_bodies.h"

#include <iostream>
#include <memory>

namespace keiko::cli {
namespace {

struct CompareArguments {
    SceneArguments loading;
    std::filesystem::path before, after;
    CompareBodiesOptions options;
    std::string preset;
};

int compare(const CompareArguments& arguments, const Job& job) {
    CompareBodiesOptions options = arguments.options;
    if (!arguments.preset.empty()) options.preset = preset_by_name(arguments.preset);
    options.load = load_options(arguments.loading);
    const BodyComparison comparison =
        compare_bodies(arguments.before, arguments.after, options, job);
    std::cout << comparison_text(comparison);
    return comparison.same() ? exit_pass : exit_findings;
}

} // namespace

void add_compare(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<CompareArguments>();
    CompareBodiesOptions& options = arguments->options;
    CLI::App& command = *app.add_subcommand(
        "compare", "tell how a revision of a part deviates from the one before");
    command.add_option("BEFORE", arguments->before, "model file")->required();
    command.add_option("AFTER", arguments->after, "model file in the same coordinates")->required();
    add_load_options(command, arguments->loading);
    command.add_option("--preset", arguments->preset, "limits by name [class-a-outer]");
    command.add_option("--join", options.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command
        .add_option("--tolerance", options.tolerance.deviation,
                    "mm that surfaces may be apart and still be the same")
        ->check(number_between(0, 1e6))
        ->capture_default_str();
    command
        .add_option("--angle-tolerance", options.tolerance.normal,
                    "degrees that their normals may be apart")
        ->check(number_between(0, 180))
        ->capture_default_str();
    command
        .add_option("--samples", options.deviation.samples,
                    "about how many places of a body deviations are measured at, and sought from")
        ->check(number_between(1, 1e8))
        ->capture_default_str();
    command.footer("Example: keiko compare fender-a.step fender-b.step");
    session.add_command(command, [arguments](const Job& job) { return compare(*arguments, job); });
}

} // namespace keiko::cli
