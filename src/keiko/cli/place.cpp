#include "keiko/cli/commands.h"
#include "keiko/cli/scene_options.h"

#include <iostream>
#include <memory>

namespace keiko::cli {
namespace {

struct PlaceArguments {
    SceneArguments scene;
    std::vector<std::string> views;
    PlacementOptions options;
    std::filesystem::path output;
};

int place(const PlaceArguments& arguments, const Job& job) {
    const Scene scene = arguments.scene.open(job);
    std::vector<Camera> cameras;
    for (const NamedView& view : choose_views(scene, arguments.views, 1, job))
        cameras.push_back(view.camera);
    const Placement placement =
        place_lamps(scene.tracer, scene.model, cameras, arguments.options, job);
    write_rig(arguments.output, placement.rig);
    std::cout << placement.planes.size() << " rows of lamps cover " << 100 * placement.coverage
              << " % of the picture; see " << arguments.output.string() << "\n";
    return exit_pass;
}

} // namespace

void add_place(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<PlaceArguments>();
    CLI::App& command =
        *app.add_subcommand("place", "hang lamps where the body mirrors them into the eye");
    arguments->scene.add_to(command, "MODEL|SCENE");
    command.add_option("-o,--output", arguments->output, "rig file to write")->required();
    command.add_option("--view", arguments->views, "view by name, or auto; may repeat [auto]");
    command.add_option("--lamps", arguments->options.lamps, "lamps in a row; 0: as many as fit")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    command.footer("Example: keiko place hood.step -o hood-rig.toml --view high-front");
    session.add_command(command, [arguments](const Job& job) { return place(*arguments, job); });
}

} // namespace keiko::cli
