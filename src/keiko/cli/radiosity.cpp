#include "keiko/api/light.h"
#include "keiko/api/results.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/log.h"
#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <iomanip>
#include <memory>

namespace keiko::cli {
namespace {

struct RadiosityArguments {
    SceneArguments scene;
    std::filesystem::path output;
};

void print_summary(const RadiositySolution& solution, const std::filesystem::path& output) {
    const EnergyBalance& balance = solution.balance;
    TextLines summary;
    summary.line() << output.string() << ": " << solution.elements << " elements in "
                   << solution.triangles.size() << " triangles, " << solution.factor_rows
                   << " rows of form factors";
    summary.line() << std::setprecision(5) << "reflected first " << luminance(balance.emitted)
                   << " lm, absorbed " << luminance(balance.absorbed) << " lm, escaped "
                   << luminance(balance.escaped) << " lm, missing " << luminance(balance.missing())
                   << " lm";
    summary.line() << std::setprecision(2) << "not yet reflected: at most "
                   << 100 * solution.remaining << " % of the light";
    print(summary.text());
}

int radiosity(const RadiosityArguments& arguments, const Job& job) {
    require_place_for_file(arguments.output);
    withdraw_results({.files = {arguments.output}, .folders = {}}, arguments.scene.inputs);
    constexpr double opening = 1, solving = 4;
    JobSteps steps(job, opening + solving);
    const Scene scene = arguments.scene.open(steps.next_of_steps(opening));
    log_remarks(radiosity_remarks(scene));
    const RadiositySolution solution = solve_radiosity(scene, steps.next_of_steps(solving));
    write_solution(arguments.output, solution);
    print_summary(solution, arguments.output);
    if (!job.stop.stop_requested()) return exit_pass;
    log_warning("interrupted: the solution lacks the light that is told");
    return exit_interrupted;
}

} // namespace

void add_radiosity(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<RadiosityArguments>();
    CLI::App& command = *app.add_subcommand(
        "radiosity", "solve the light that diffuse surfaces reflect onto each other");
    arguments->scene.add_to(command, "SCENE");
    arguments->scene.options.shadows = true;
    command.add_option("-o,--output", arguments->output, "solution to write (keiko-solution/1)")
        ->type_name("FILE")
        ->required();
    command.footer(
        "keiko illuminance, render, panorama and view take it by --solution. It holds for the "
        "scene's geometry, "
        "lamps and reflectances, whatever the view and the levels of the lamps; [radiosity] of the "
        "scene says how fine it is. "
        "Interrupted, it keeps the light that has been found.\n"
        "Exit codes: 0 solved, 2 error, 130 interrupted.\n"
        "Example: keiko radiosity room-scene.toml -o room.solution");
    session.add_command(command,
                        [arguments](const Job& job) { return radiosity(*arguments, job); });
}

} // namespace keiko::cli
