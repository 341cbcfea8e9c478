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

int info(const InfoArguments& arguments, const Job& job) {
    const SurfaceModel model =
        load_model(arguments.scene.inputs.front(), load_options(arguments.scene), job);
    const ModelFacts facts = model_facts(model, pair_seams(model, InspectOptions{}.join, job), job);
    std::cout << (arguments.json ? facts_json(facts) : facts_text(facts));
    return exit_pass;
}

} // namespace

void add_info(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App& command = *app.add_subcommand("info", "tell what is in a model file");
    command.add_option("MODEL", arguments->scene.inputs, "a STEP, IGES, BREP or .bpt file")
        ->required()
        ->expected(1);
    command.add_flag("--json", arguments->json, "machine-readable");
    add_load_options(command, arguments->scene);
    command.footer("Example: keiko info fender.step --json");
    session.add_command(command, [arguments](const Job& job) { return info(*arguments, job); });
}

} // namespace keiko::cli
