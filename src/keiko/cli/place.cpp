#include "keiko/cli/commands.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/output_place.h"
#include "keiko/cli/scene_options.h"

#include <array>
#include <cstdio>
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

/// Any other name may be that of the model, which would be overwritten.
void require_rig_extension(const std::filesystem::path& path) {
    if (path.extension() != ".toml")
        throw Error(path.string(), "", "a rig is written as a file that ends in .toml");
}

void print_summary(const Placement& placement, const std::filesystem::path& output) {
    const std::size_t rows = placement.planes.size();
    std::array<char, 32> share{};
    std::snprintf(share.data(), share.size(), "%.1f", 100 * placement.coverage);
    std::cout << rows << (rows == 1 ? " row of lamps covers " : " rows of lamps cover ")
              << share.data() << " % of the picture; see " << output.string() << "\n";
}

int place(const PlaceArguments& arguments, const Job& job) {
    require_rig_extension(arguments.output);
    require_place_for_file(arguments.output);
    require_view_names(arguments.views);
    const Scene scene = arguments.scene.open(job);
    std::vector<Camera> cameras;
    for (const NamedView& view : choose_views(scene, arguments.views, 1, job))
        cameras.push_back(view.camera);
    const Placement placement =
        place_lamps(scene.tracer, scene.model, cameras, arguments.options, job);
    write_rig(arguments.output, placement.rig);
    print_summary(placement, arguments.output);
    return exit_pass;
}

} // namespace

void add_place(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<PlaceArguments>();
    CLI::App& command =
        *app.add_subcommand("place", "hang lamps where the body mirrors them into the eye");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_picture_size(command);
    command.add_option("-o,--output", arguments->output, "rig file to write")->required();
    command.add_option("--view", arguments->views, "view by name, or auto; may repeat [auto]")
        ->allow_extra_args(false);
    command.add_option("--lamps", arguments->options.lamps, "lamps in a row; 0: as many as fit")
        ->check(number_between(0, 64))
        ->capture_default_str();
    command.footer("Example: keiko place hood.step -o hood-rig.toml --view high-front");
    session.add_command(command, [arguments](const Job& job) { return place(*arguments, job); });
}

} // namespace keiko::cli
