#include "keiko/api/check.h"
#include "keiko/api/lines.h"
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/output_file.h"
#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"

#include <algorithm>
#include <map>
#include <memory>

namespace keiko::cli {
namespace {

struct DrawArguments {
    SceneArguments scene;
    DrawOptions options;
    std::string hidden = "remove", paper = "A3";
    std::vector<std::string> planes;
    bool wireframe = false, findings = false;
    std::string preset;
    std::filesystem::path rig, output;
};

std::vector<std::string> kind_names() {
    std::vector<std::string> names;
    for (std::size_t kind = 0; kind < curve_kinds; ++kind)
        names.emplace_back(name_of(static_cast<CurveKind>(kind)));
    return names;
}

DrawOptions draw_options(const DrawArguments& arguments) {
    DrawOptions options = arguments.options;
    options.paper = paper_size(arguments.paper);
    options.hidden = arguments.wireframe          ? HiddenLines::draw
                     : arguments.hidden == "dash" ? HiddenLines::dash
                                                  : HiddenLines::remove;
    for (const std::string& plane : arguments.planes)
        options.curves.planes.push_back(section_plane(plane));
    options.curves.join = options.join;
    if (!arguments.preset.empty() && !arguments.findings)
        throw Error("", "--preset", "needs --findings");
    if (arguments.findings)
        options.findings = arguments.preset.empty() ? standard_presets().front()
                                                    : preset_by_name_or_file(arguments.preset);
    if (!arguments.rig.empty()) options.rig = read_rig_aloud(arguments.rig);
    return options;
}

void print_summary(const Sheet& sheet, const std::filesystem::path& output) {
    TextLines summary;
    std::ostream& line = summary.line();
    line << output.string() << ": ";
    bool first = true;
    for (const SheetLayer& layer : sheet.layers) {
        line << (first ? "" : ", ") << layer.lines.size() << ' ' << layer.name;
        first = false;
    }
    print(summary.text());
}

int draw(const DrawArguments& arguments, const Job& job) {
    require_place_for_file(arguments.output);
    if (!is_sheet_output(arguments.output))
        throw Error(arguments.output.string(), "",
                    "is no drawing: its name does not end in .svg, .dxf or .pdf");
    require_view_names(arguments.options.views);
    const DrawOptions options = draw_options(arguments);
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.insert(inputs.end(), options.views.begin(), options.views.end());
    inputs.push_back(arguments.rig);
    inputs.emplace_back(arguments.preset);
    withdraw_results({.files = {arguments.output}, .folders = {}}, inputs);
    constexpr double opening = 1, drawing = 2;
    JobSteps steps(job, opening + drawing);
    const Scene scene = arguments.scene.open(steps.next_of_steps(opening));
    arguments.scene.warn_of_axes(scene, options.views);
    const Sheet sheet = draw_scene(scene, options, steps.next_of_steps(drawing));
    write_text_file(arguments.output, sheet_output(sheet, arguments.output));
    print_summary(sheet, arguments.output);
    return exit_pass;
}

void add_curve_options(CLI::App& command, DrawArguments& arguments) {
    DrawOptions& options = arguments.options;
    command
        .add_option("--section", arguments.planes,
                    "plane x=MM, y=MM, z=MM or A,B,C=MM: its section; may repeat")
        ->allow_extra_args(false);
    command
        .add_option("--iso-curves", options.curves.iso_curves,
                    "number of iso-curves of each face in either direction")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    command.add_option("--rig", arguments.rig, "rig file: the reflection lines of its lamps");
    command.add_flag("--findings", arguments.findings,
                     "numbers of what the body's geometry is judged to fail or be undecided in");
    command.add_option("--preset", arguments.preset,
                       "limits of --findings by name, or a preset file (.toml) [class-a-outer]");
    command
        .add_option("--without", options.without,
                    "layer that is left out: outlines, edges, creases, seams, iso-curves, "
                    "sections or lines; may repeat")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(kind_names()))
        ->option_text("NAME");
    command
        .add_option("--crease", options.crease_angle,
                    "degrees above which a seam is a crease, at its sharpest place")
        ->check(number_between(0, 180))
        ->capture_default_str();
    command.add_option("--join", options.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
}

} // namespace

void add_draw(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<DrawArguments>();
    CLI::App& command = *app.add_subcommand(
        "draw", "draw outlines, edges and other curves as vectors, hidden lines removed");
    arguments->scene.add_to(command, "MODEL|SCENE");
    command.add_option("-o,--output", arguments->output, "SVG, DXF or PDF file to write")
        ->required();
    command
        .add_option("--view", arguments->options.views,
                    "view by name, or auto; may repeat [left, front and top]")
        ->allow_extra_args(false);
    command.add_flag("--perspective", arguments->options.perspective,
                     "from the eyes of the views, not by parallel rays");
    command
        .add_option("--hidden", arguments->hidden,
                    "of hidden lines: remove, or dash to draw them dashed")
        ->check(CLI::IsMember({"remove", "dash"}))
        ->option_text("NAME")
        ->capture_default_str();
    command.add_flag("--wireframe", arguments->wireframe, "all lines, as if nothing hid them")
        ->excludes("--hidden");
    add_curve_options(command, *arguments);
    command.add_option("--paper", arguments->paper, "A4, A3, A2, A1 or A0, wider than high")
        ->check(CLI::IsMember({"A4", "A3", "A2", "A1", "A0"}))
        ->option_text("NAME")
        ->capture_default_str();
    command.add_option("--title", arguments->options.title,
                       "text of the title block [the names of the files]");
    command.footer(
        "Exit codes: 0 drawn, 2 error, 130 interrupted.\n"
        "Example: keiko draw fender.step -o fender.svg --hidden dash");
    session.add_command(command, [arguments](const Job& job) { return draw(*arguments, job); });
}

} // namespace keiko::cli
