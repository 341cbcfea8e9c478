#include "keiko/api/light.h"
#include "keiko/base/log.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"
#include "keiko/cli/standard_streams.h"

#include <memory>

namespace keiko::cli {
namespace {

struct IlluminanceArguments {
    SceneArguments scene;
    SightLimits limits;
    bool summary = false, sight = false;
};

int illuminance(const IlluminanceArguments& arguments, const Job& job) {
    const StandardInput input(job);
    const StandardOutput output(job);
    const Scene scene = arguments.scene.open(job);
    if (scene.rig) log_remarks(hidden_lamp_remarks(*scene.rig, scene.tracer.bounds()));
    const ByteSource read = [&](std::span<char> bytes) { return input.read(bytes); };
    const ByteSink write = [&](std::string_view text) { return output.write(text); };
    const std::uint64_t points = arguments.sight
                                     ? sight_points(scene, arguments.limits, read, write, job)
                                 : arguments.summary ? summarize_points(scene, read, write, job)
                                                     : light_points(scene, read, write, job);
    log_detail(std::to_string(points) + " points");
    return exit_pass;
}

} // namespace

void add_illuminance(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<IlluminanceArguments>();
    CLI::App& command =
        *app.add_subcommand("illuminance",
                            "tell how much light lamps shed on points: CSV from standard input to "
                            "standard output");
    arguments->scene.add_to(command, "SCENE");
    arguments->scene.options.shadows = true;
    CLI::Option* solution = arguments->scene.add_solution(command);
    command.add_flag("--summary", arguments->summary,
                     "instead of a row for each point one for each source and one for the sum: "
                     "points, least, mean and largest illuminance, uniformity (least over mean)");
    CLI::Option* sight = command.add_flag(
        "--sight", arguments->sight,
        "what eyes see in fog: lines of an eye and a direction, ox,oy,oz,dx,dy,dz; a row has the "
        "contrast and the visual range of the surface ahead, of the scene's signs, and the light "
        "and the range of its bare lamps");
    sight->excludes("--summary")->excludes(solution);
    command.add_option("--least-contrast", arguments->limits.contrast, "that an eye can see")
        ->check(number_between(1e-6, 1))
        ->capture_default_str()
        ->needs(sight);
    command
        .add_option("--least-lux", arguments->limits.lux,
                    "of a lamp at the eye that can be seen: 2e-7 on a dark night, 1e-4 in "
                    "twilight, 1e-3 by day")
        ->check(number_between(1e-12, 1e6))
        ->capture_default_str()
        ->needs(sight);
    command.footer(
        "Reads x,y,z,nx,ny,nz a line: a point (mm) and the normal of the surface there, of any "
        "length (line 1 may name the columns). Writes a header line and a row for each point in "
        "order: direct illuminance in lx of each source of the scene's rig, that of surfaces "
        "with --solution, and the sum. A point inside a lamp or in a focus of caustics ends it, as "
        "a malformed line does.\n"
        "Example: keiko illuminance hood-scene.toml < points.csv > lux.csv");
    session.add_command(command,
                        [arguments](const Job& job) { return illuminance(*arguments, job); });
}

} // namespace keiko::cli
