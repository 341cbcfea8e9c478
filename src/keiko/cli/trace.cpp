#include "keiko/api/trace.h"

#include "keiko/base/log.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"
#include "keiko/cli/standard_streams.h"

#include <memory>

namespace keiko::cli {
namespace {

struct TraceArguments {
    SceneArguments scene;
    TraceOptions options;
};

int trace(const TraceArguments& arguments, const Job& job) {
    require_columns(arguments.options);
    const StandardInput input(job);
    const StandardOutput output(job);
    SceneArguments inputs = arguments.scene;
    // Only light is shadowed, and occluders take time to find.
    if (!light_column(hit_columns(arguments.options.columns))) inputs.options.shadows = false;
    const Scene scene = inputs.open(job);
    const TraceCounts counts = trace_rays(
        scene, [&](std::span<char> bytes) { return input.read(bytes); },
        [&](std::string_view text) { return output.write(text); }, arguments.options, job);
    log_detail(std::to_string(counts.rays) + " rays, " + path_text(counts.hits));
    return exit_pass;
}

} // namespace

void add_trace(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<TraceArguments>();
    CLI::App& command = *app.add_subcommand(
        "trace", "tell where rays meet the surfaces: CSV from standard input to standard output");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_shadows(command);
    command
        .add_option("--out", arguments->options.columns,
                    "columns, comma-separated: t, instance, face, patch, u, v, x, y, z, nx, ny, "
                    "nz, k1, k2 (1/mm), bound (mm), flags (unique, clipped, tangential, seam, "
                    "with | between), luminance, r, g, b (cd/m2, of a scene with a rig)")
        ->capture_default_str();
    command.add_flag("--all", arguments->options.all,
                     "every hit, led by the number of its ray from 0, not the first alone");
    command.footer(
        "Reads ox,oy,oz,dx,dy,dz a line (mm; t counts in lengths of the direction; line 1 may name "
        "the columns). Writes a header line and a row for each ray in order; a miss is a row of "
        "empty fields.\n"
        "Example: keiko trace hood.step --out t,face,x,y,z,k1,k2 < rays.csv > hits.csv");
    session.add_command(command, [arguments](const Job& job) { return trace(*arguments, job); });
}

} // namespace keiko::cli
