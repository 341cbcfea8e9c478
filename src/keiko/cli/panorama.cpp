#include "keiko/api/render.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace keiko::cli {
namespace {

struct PanoramaArguments {
    SceneArguments scene;
    std::vector<double> at;
    std::filesystem::path output, rig;
    int width = 1024;
    bool cube = false;
};

LightRig rig_of(const Scene& scene, const std::filesystem::path& file) {
    if (!file.empty()) return read_rig_aloud(file);
    if (scene.rig) return *scene.rig;
    throw Error(source_of(scene), "", "has no lamps to be seen; name a rig by --rig");
}

PanoramaView view_of(const PanoramaArguments& arguments) {
    for (const double coordinate : arguments.at)
        if (!(std::abs(coordinate) <= 1e9))
            throw Error("", "--at", "coordinates must be from -1e9 to 1e9 mm");
    PanoramaView view;
    view.eye = {arguments.at[0], arguments.at[1], arguments.at[2]};
    view.width = arguments.width;
    if (arguments.cube) view.layout = EnvironmentSpec::Layout::cube;
    return view;
}

int panorama(const PanoramaArguments& arguments, const Job& job) {
    const PanoramaView view = view_of(arguments);
    require_image_extension(arguments.output);
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.push_back(arguments.rig);
    inputs.push_back(arguments.scene.solution);
    withdraw_results({.files = {arguments.output}, .folders = {}}, inputs);
    const Scene scene = arguments.scene.open(job);
    const LightRig rig = rig_of(scene, arguments.rig);
    write_film(arguments.output,
               render_panorama(scene.picture(rig), view, picture_options(scene), job));
    return exit_pass;
}

} // namespace

void add_panorama(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<PanoramaArguments>();
    CLI::App& command = *app.add_subcommand(
        "panorama", "render what a mirror at a place sees in all directions, as an environment");
    arguments->scene.add_to(command, "SCENE");
    arguments->scene.add_shadows(command);
    command.add_option("--at", arguments->at, "place, mm")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->required();
    command
        .add_option("-o,--output", arguments->output, "picture: .exr in cd/m2, or .png to look at")
        ->type_name("FILE")
        ->required();
    CLI::Option* rig =
        command.add_option("--rig", arguments->rig, "rig file instead of the scene's lamps")
            ->type_name("FILE");
    arguments->scene.add_solution(command)->needs("--shadows")->excludes(rig);
    command
        .add_option("--width", arguments->width,
                    "pixels of a row, twice the height; with --cube of the side of a square")
        ->check(CLI::Range(2, 16384))
        ->capture_default_str();
    command.add_flag("--cube", arguments->cube,
                     "six squares side by side (+x, -x, +y, -y, +z, -z) instead of azimuth and "
                     "angle to the zenith");
    command.footer(
        "The picture holds lamps and bodies as they are seen from that place alone: mirrors that "
        "show it as [environment] of a scene know no parallax. A body that will show it is to be "
        "left out of the scene, or it mirrors itself from afar.\n"
        "Example: keiko panorama studio-scene.toml --at 0,0,800 -o studio.exr");
    session.add_command(command, [arguments](const Job& job) { return panorama(*arguments, job); });
}

} // namespace keiko::cli
