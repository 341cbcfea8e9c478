#include "keiko/cli/commands.h"
#include "keiko/cli/scene_options.h"

#include <iostream>
#include <memory>

namespace keiko::cli {
namespace {

struct InfoArguments {
    SceneArguments scene; ///< only inputs and load options
    bool json = false;
};

int info(const InfoArguments& arguments, bool verbose, const Job& job) {
    const FactsOptions options{.load = load_options(arguments.scene), .tracing = verbose};
    const ModelFacts facts = file_facts(arguments.scene.inputs.front(), options, job);
    std::cout << (arguments.json ? facts_json(facts) : facts_text(facts));
    return exit_pass;
}

} // namespace

void add_info(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App& command = *app.add_subcommand("info", "tell what is in a model file");
    command.add_option("MODEL", arguments->scene.inputs, "a STEP, IGES, BREP, .bpt or .obj file")
        ->required()
        ->expected(1);
    command.add_flag("--json", arguments->json, "machine-readable, with every part and face");
    add_load_options(command, arguments->scene);
    command.footer(
        "With --verbose also the leaves, the memory and the build time of the ray tracer.\n"
        "Example: keiko info fender.step --json");
    session.add_command(command, [arguments, &session](const Job& job) {
        return info(*arguments, session.verbose(), job);
    });
}

} // namespace keiko::cli
