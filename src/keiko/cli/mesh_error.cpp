#include "keiko/api/compare.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/log.h"
#include "keiko/base/output_folder.h"
#include "keiko/cli/option_values.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <memory>

namespace keiko::cli {
namespace {

struct MeshErrorArguments {
    SceneArguments scene;
    MeshErrorOptions options;
    std::string rig = "auto", normals = "surface", mesher = "opencascade";
    std::filesystem::path output = "keiko-mesh-error", json;
};

void withdraw_earlier(const MeshErrorArguments& arguments) {
    require_place_for_folder(arguments.output);
    if (!arguments.json.empty()) require_place_for_file(arguments.json);
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.insert(inputs.end(), arguments.options.views.begin(), arguments.options.views.end());
    inputs.emplace_back(arguments.rig);
    const std::vector<std::filesystem::path> files{arguments.json};
    require_distinct(files, inputs);
    withdraw_results({.files = files, .folders = {arguments.output}}, inputs);
}

void write_outputs(const MeshErrorArguments& arguments, const MeshErrorReport& report) {
    FileTransaction batch;
    batch.add_folder(arguments.output, with_manifest(mesh_error_files(report)));
    if (!arguments.json.empty()) batch.add(arguments.json, mesh_error_json(report));
    batch.write();
}

int mesh_error(MeshErrorArguments arguments, const Job& job) {
    withdraw_earlier(arguments);
    if (arguments.rig != "auto") {
        arguments.options.rig = arguments.rig;
        read_rig_aloud(arguments.rig);
    }
    require_view_names(arguments.options.views);
    arguments.options.load = load_options(arguments.scene);
    arguments.options.normals = corner_normals_by_name(arguments.normals);
    arguments.options.mesher = mesher_by_name(arguments.mesher);
    constexpr double opening = 1, comparing = 9;
    JobSteps steps(job, opening + comparing);
    const Scene scene = arguments.scene.open(steps.next_of_steps(opening));
    arguments.scene.warn_of_axes(scene, arguments.options.views);
    const MeshErrorReport report =
        keiko::mesh_error(scene, arguments.options, steps.next_of_steps(comparing));
    write_outputs(arguments, report);
    for (const ComparedMesh& mesh : report.meshes)
        for (const std::string& face : mesh.lost_faces) log_warning(face);
    if (!wrong_share(report, 0))
        log_warning("nothing was compared: no pixel mirrors the lamps, which are " + report.lamps);
    print(mesh_error_text(report));
    return exit_pass;
}

} // namespace

void add_mesh_error(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<MeshErrorArguments>();
    CLI::App& command = *app.add_subcommand(
        "mesh-error", "tell what a mesh, as viewports have it, does to the reflections of a body");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_picture_size(command);
    command
        .add_option("--mesh", arguments->options.deviations,
                    "mm by which the surface may leave the triangles, comma-separated: a mesh each")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_between(1e-6, 1e6))
        ->default_str("1,0.1");
    add_mesher(command, arguments->mesher);
    command
        .add_option("--normals", arguments->normals,
                    "at the corners of the triangles: surface, its own; or averaged "
                    "within each face over the triangles around")
        ->check(CLI::IsMember({"surface", "averaged"}))
        ->option_text("NAME")
        ->capture_default_str();
    command.add_option("-o,--output", arguments->output, "folder for the page and its pictures")
        ->capture_default_str();
    command.add_option("--json", arguments->json, "file for the numbers");
    command
        .add_option("--view", arguments->options.views,
                    "view by name, or auto; may repeat [three automatic ones]")
        ->allow_extra_args(false);
    command.add_option("--rig", arguments->rig, "rig file, or auto: the scene's, or placed")
        ->check(not_empty())
        ->capture_default_str();
    command.footer(
        "Exit codes: 0 compared, 2 error, 130 interrupted.\n"
        "Example: keiko mesh-error hood.step --mesh 1,0.1 -o mesh-error");
    session.add_command(command,
                        [arguments](const Job& job) { return mesh_error(*arguments, job); });
}

} // namespace keiko::cli
