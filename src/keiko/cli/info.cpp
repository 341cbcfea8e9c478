#include "keiko/api/model.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <memory>

namespace keiko::cli {
namespace {

struct InfoArguments {
    SceneArguments scene; ///< only inputs and load options
    bool json = false;
    std::string svg; ///< file for the polar curve of a luminaire; empty: none
};

int luminaire_info(const InfoArguments& arguments, const std::filesystem::path& file) {
    if (!arguments.svg.empty()) require_place_for_file(arguments.svg);
    withdraw_results({.files = {arguments.svg}, .folders = {}}, {&file, 1});
    const LuminaireFacts facts = luminaire_facts(file.string(), read_luminaire(file));
    if (!arguments.svg.empty()) write_text_file(arguments.svg, polar_curve_svg(facts));
    print(arguments.json ? luminaire_json(facts) : luminaire_text(facts));
    return exit_pass;
}

int info(const InfoArguments& arguments, bool verbose, const Job& job) {
    const std::filesystem::path file = arguments.scene.inputs.front();
    if (is_luminaire_file(file)) return luminaire_info(arguments, file);
    if (!arguments.svg.empty())
        throw Error(file.string(), "", "--svg draws luminaires alone: an .ies or .ldt file");
    const FactsOptions options{.load = load_options(arguments.scene), .tracing = verbose};
    const ModelFacts facts = model_info(file, options, job);
    print(arguments.json ? facts_json(facts) : facts_text(facts));
    return exit_pass;
}

} // namespace

void add_info(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App& command = *app.add_subcommand("info", "tell what is in a model or luminaire file");
    command
        .add_option("FILE", arguments->scene.inputs,
                    "a STEP, IGES, BREP, .bpt or .obj file, or a luminaire: .ies or .ldt")
        ->required()
        ->expected(1);
    command.add_flag("--json", arguments->json, "machine-readable, with every part and face");
    command.add_option("--svg", arguments->svg,
                       "of a luminaire: draw its polar curve into this file");
    add_load_options(command, arguments->scene);
    command.footer(
        "With --verbose also the sub-patches, the memory and the build time of the ray tracer.\n"
        "Example: keiko info fender.step --json\n"
        "Example: keiko info street.ldt --svg street.svg");
    session.add_command(command, [arguments, &session](const Job& job) {
        return info(*arguments, session.verbose(), job);
    });
}

} // namespace keiko::cli
