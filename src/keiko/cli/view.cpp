#include "keiko/api/view.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/log.h"
#include "keiko/cli/browser.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"
#include "keiko/viewer/viewer.h"

#include <iostream>
#include <memory>
#include <optional>

namespace keiko::cli {
namespace {

struct ViewArguments {
    SceneArguments scene;
    std::vector<std::filesystem::path> against;
    viewer::ViewerOptions options;
    std::string view, rig = "auto", preset;
    bool no_browser = false;
};

LightRig rig_of(const Scene& scene, const ViewArguments& arguments, const NamedView& view,
                const Job& job) {
    std::optional<std::filesystem::path> rig;
    if (arguments.rig != "auto") rig = arguments.rig;
    return choose_lights(scene, rig, {&view, 1}, {}, job).rig;
}

/// Prints the address, and opens it in the user's browser unless he wants none.
void announce(const std::string& address, bool no_browser, std::optional<AddressPage>& page) {
    print(address + "\n");
    std::cout.flush(); // programs that start this one wait for the line
    if (no_browser) return;
    page.emplace(address);
    if (!page->show()) log_warning("there is no xdg-open: open the address in a browser");
}

/// The earlier revision, opened as the scene is; nullopt unless one is named.
std::optional<Scene> earlier_scene(const ViewArguments& arguments, const Job& job) {
    if (arguments.against.empty()) return {};
    SceneArguments earlier = arguments.scene;
    earlier.inputs = arguments.against;
    earlier.options.analysis.reset(); // of the body that is judged
    return earlier.open(job);
}

/// Opens a report folder in place of the models: with its lamps and its analysis, unless others are
/// named.
void open_report(ViewArguments& arguments) {
    if (arguments.scene.inputs.size() != 1 || !is_report_folder(arguments.scene.inputs.front()))
        return;
    if (!arguments.scene.solution.empty())
        throw Error(arguments.scene.inputs.front().string(), "",
                    "is a report, whose pictures have no light of a --solution");
    ReportFolder report = read_report_folder(arguments.scene.inputs.front());
    log_remarks(report.changes);
    arguments.scene.inputs = report.inputs;
    if (arguments.rig == "auto" && arguments.scene.analysis.empty())
        arguments.rig = report.rig.string();
    if (arguments.scene.analysis.empty()) arguments.scene.analysis = report.analysis;
    arguments.options.report = std::move(report);
}

/// The first view of a report, or the one that is named; nullopt if it is none of the report's, or
/// if there is an analysis, whose views come first.
std::optional<NamedView> view_of_report(const ViewArguments& arguments) {
    if (!arguments.options.report || arguments.scene.options.analysis) return {};
    const PictureSize size = arguments.scene.picture_size();
    for (NamedView seen : arguments.options.report->views) {
        if (!arguments.view.empty() && arguments.view != seen.name) continue;
        if (size.width > 0) seen.camera.width = size.width, seen.camera.height = size.height;
        return seen;
    }
    return {};
}

int view(ViewArguments arguments, const Job& job) {
    open_report(arguments);
    arguments.scene.read_analysis();
    const std::optional<NamedView> of_report = view_of_report(arguments);
    std::vector<std::string> names;
    if (!arguments.view.empty()) names.push_back(arguments.view);
    if (!of_report) require_view_names(names, arguments.scene.options.analysis);
    if (arguments.rig != "auto") read_rig_aloud(arguments.rig);
    if (!arguments.preset.empty())
        arguments.options.check.preset = preset_by_name_or_file(arguments.preset);
    arguments.options.check.load = load_options(arguments.scene);
    arguments.options.solution = arguments.scene.solution;
    Scene scene = arguments.scene.open(job);
    std::optional<Scene> against = earlier_scene(arguments, job);
    arguments.scene.warn_of_axes(scene, names);
    const NamedView seen = of_report ? *of_report : choose_views(scene, names, 1, job).front();
    LightRig rig = rig_of(scene, arguments, seen, job);
    // It ends with the server: the page may be opened again as long as that runs.
    std::optional<AddressPage> page;
    viewer::show(
        {std::move(scene), std::move(against)}, seen, std::move(rig), arguments.options,
        [&](const std::string& address) { announce(address, arguments.no_browser, page); }, job);
    return exit_pass;
}

} // namespace

void add_view(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<ViewArguments>();
    CLI::App& command = *app.add_subcommand(
        "view", "show the body under lamps in the browser, to turn it and to drag the lamps");
    arguments->scene.add_to(command, "MODEL|SCENE|REPORT");
    CLI::Option* against =
        command
            .add_option("--against", arguments->against,
                        "an earlier revision to compare with: its model file or scene file; may "
                        "repeat for the models of one body")
            ->allow_extra_args(false);
    arguments->scene.add_picture_size(command);
    arguments->scene.add_shadows(command);
    arguments->scene.add_analysis(command);
    CLI::Option* solution = arguments->scene.add_solution(command);
    command.add_option("--view", arguments->view, "view by name, auto, or scene")
        ->check(not_empty());
    CLI::Option* rig =
        command.add_option("--rig", arguments->rig, "rig file, or auto: the scene's, or placed")
            ->check(not_empty())
            ->capture_default_str();
    solution->needs("--shadows")->excludes(against)->excludes(rig);
    command.add_option("--preset", arguments->preset,
                       "limits of the seams by name, or a preset file (.toml) [class-a-outer]");
    command
        .add_option("--join", arguments->options.check.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command
        .add_option("--port", arguments->options.port,
                    "of this machine alone, 127.0.0.1; 0: one that is free")
        ->check(CLI::Range(0, 65535))
        ->capture_default_str();
    command.add_flag("--no-browser", arguments->no_browser,
                     "print the address, and leave it to you to open it");
    command.footer(
        "A folder of keiko inspect opens with its lamps, views and faults.\n"
        "It shows the scene until Ctrl-C. The address holds the key to it: keep it to yourself.\n"
        "Example: keiko view hood.step --view high-front");
    session.add_command(command, [arguments](const Job& job) { return view(*arguments, job); });
}

} // namespace keiko::cli
