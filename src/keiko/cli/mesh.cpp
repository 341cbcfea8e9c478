#include "keiko/cli/mesh.h"

#include "keiko/api/model.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/log.h"
#include "keiko/base/output_folder.h"
#include "keiko/base/text.h"
#include "keiko/cli/option_values.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <array>
#include <functional>
#include <map>
#include <memory>

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

struct MeshArguments {
    SceneArguments scene;
    std::vector<fs::path> outputs;
    std::vector<std::string> fields;
    fs::path against;
    std::string pull, scale;
    std::string mesher = "opencascade";
    double deviation = MeshOptions{}.deviation, reach = 0;
};

using Writer = std::function<std::string(const SurfaceMesh&, const std::optional<ValueRange>&)>;

/// The writer of a file by its ending. Throws Error for another ending.
Writer writer_of(const fs::path& file) {
    static const std::map<std::string, Writer> writers{
        {".vtp", [](const SurfaceMesh& mesh, const auto&) { return vtp_file(mesh); }},
        {".ply", ply_file},
        {".glb", glb_file}};
    const auto found = writers.find(lower_case(file.extension().string()));
    if (found == writers.end())
        throw Error("", "--output", "'" + file.string() + "' ends in none of .vtp, .ply and .glb");
    return found->second;
}

void require_outputs(const MeshArguments& arguments) {
    for (const fs::path& file : arguments.outputs) writer_of(file), require_place_for_file(file);
    std::vector<fs::path> inputs = arguments.scene.inputs;
    inputs.push_back(arguments.against);
    require_distinct(arguments.outputs, inputs);
    withdraw_results({.files = arguments.outputs, .folders = {}}, inputs);
}

MeshOptions options_of(const MeshArguments& arguments) {
    MeshOptions options;
    options.deviation = arguments.deviation, options.reach = arguments.reach;
    for (const std::string& name : arguments.fields)
        options.fields.push_back(surface_field_by_name(name));
    if (!arguments.pull.empty()) options.pull = direction("--pull", arguments.pull);
    options.load = load_options(arguments.scene);
    options.mesher = mesher_by_name(arguments.mesher);
    return options;
}

ValueRange scale_of(const std::string& text) {
    const auto range = value_range(text);
    if (!range) throw Error("", "--scale", "'" + text + "' is not MIN:MAX with MIN < MAX");
    return *range;
}

void tell(const SurfaceMesh& mesh) {
    for (const std::string& face : mesh.lost_faces) log_warning(face);
    TextLines lines;
    lines.line() << counted(mesh.triangles.size(), "triangle") << ", "
                 << counted(mesh.positions.size(), "corner") << ", within " << mesh.deviation
                 << " mm of the exact surface";
    print(lines.text());
}

int mesh(const MeshArguments& arguments, const Job& job) {
    require_outputs(arguments);
    MeshOptions options = options_of(arguments);
    std::optional<ValueRange> range;
    if (!arguments.scale.empty()) range = scale_of(arguments.scale);
    JobSteps steps(job, 3);
    const Scene scene = arguments.scene.open(steps.next_of_steps(1));
    std::optional<Scene> other;
    if (!arguments.against.empty()) {
        const std::array inputs{arguments.against};
        other = open_scene(inputs, arguments.scene.scene_options(), steps.next_of_steps(1));
        options.against = &*other;
    }
    const SurfaceMesh made = surface_mesh(scene, options, steps.next_of_steps(1));
    FileTransaction batch;
    for (const fs::path& file : arguments.outputs) batch.add(file, writer_of(file)(made, range));
    batch.write();
    tell(made);
    return made.lost_faces.empty() ? exit_pass : exit_findings;
}

} // namespace

void add_mesh(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<MeshArguments>();
    CLI::App& command = *app.add_subcommand(
        "mesh", "give a body to other programs in triangles, with numbers of its exact surface");
    arguments->scene.add_to(command, "MODEL");
    command
        .add_option("-o,--output", arguments->outputs,
                    "file to write, .vtp, .ply or .glb by its ending; may repeat")
        ->allow_extra_args(false)
        ->required();
    command
        .add_option("--deviation", arguments->deviation,
                    "mm by which the surface may leave the triangles")
        ->check(number_between(1e-6, 1e6))
        ->capture_default_str();
    add_mesher(command, arguments->mesher);
    command
        .add_option("--field", arguments->fields,
                    "number at every corner: k1, k2, mean, gauss, absolute, draft or deviation; "
                    "may repeat, and the first one gives the colours")
        ->allow_extra_args(false);
    command.add_option("--scale", arguments->scale,
                       "of the colours MIN:MAX [what 98 % of the corners lie within]");
    command.add_option("--pull", arguments->pull,
                       "of --field draft: X,Y,Z, where the tool is pulled off [0,0,1]");
    command.add_option("--against", arguments->against,
                       "of --field deviation: the body that it is measured from");
    command
        .add_option("--reach", arguments->reach,
                    "of --field deviation: mm within which that body is sought [a fiftieth of its "
                    "size]")
        ->check(number_between(1e-9, 1e9));
    command.footer(
        "Exit codes: 0 all faces, 1 a face gave no triangles, 2 error, 130 interrupted.\n"
        "Example: keiko mesh hood.step --field mean -o hood.vtp -o hood.glb");
    session.add_command(command, [arguments](const Job& job) { return mesh(*arguments, job); });
}

} // namespace keiko::cli
