#include "keiko/api/lines.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/output_file.h"
#include "keiko/base/text.h"
#include "keiko/cli/inspection_options.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/scope_options.h"
#include "keiko/cli/session.h"

#include <cmath>
#include <map>
#include <memory>

namespace keiko::cli {
namespace {

struct LinesArguments {
    SceneArguments scene;
    LinesOptions options;
    std::filesystem::path rig, output, csv, crossings, inflections, picture;
    CurveFilesOption curves;
    bool contours = false; ///< of the views, among the curves
    std::string preset;
    std::size_t rows = 20; ///< of the table
    ScopeOptions scope;
};

const std::map<std::string, LineLook> looks{{"reflection", LineLook::reflection},
                                            {"highlight", LineLook::highlight},
                                            {"isophote", LineLook::isophote}};

void print_summary(const LineList& list, const LinesArguments& arguments) {
    std::size_t lines = 0, pieces = 0, unproved = 0;
    double length = 0;
    for (const ViewLines& view : list.views) {
        lines += view.found.lines.size(), pieces += view.found.pieces.size();
        for (const SurfaceLine& piece : view.found.pieces) unproved += piece.line.proved ? 0 : 1;
        for (const JoinedLine& line : view.found.lines) length += line.length;
    }
    const CrossingCounts counts = count_crossings(list);
    if (counts.fail + counts.undecided + counts.pass == 0)
        print("no line crosses a seam: nothing is judged; try lamps aslant to the seams\n");
    print(crossings_table(list, arguments.rows));
    TextLines summary;
    std::ostream& line = summary.line();
    line << name_of(verdict_of(list)) << ": " << counts.fail
         << " crossings of lines and seams fail, " << counts.undecided << " undecided, "
         << counts.pass << " pass, " << counts.not_judged << " not judged; " << lines << " "
         << name_of(list.look) << " lines of " << pieces << " pieces, " << std::llround(length)
         << " mm, " << unproved << " pieces not proved; ";
    if (const std::string part = scope_words(list.scope); !part.empty())
        line << part << ", " << counted(counts.out_of_scope, "crossing") << " out of scope; ";
    line << "see " << arguments.output.string();
    print(summary.text());
    print_scope(list.scope, list.preset);
}

/// lines.png, or with several views lines-VIEW.png.
std::filesystem::path picture_of(const std::filesystem::path& path, const LineList& list,
                                 const ViewLines& view) {
    if (list.views.size() == 1) return path;
    std::filesystem::path named = path;
    return named.replace_filename(path.stem().string() + "-" + view.view + ".png");
}

void require_outputs(const LinesArguments& arguments) {
    for (const auto& path : {arguments.output, arguments.csv, arguments.crossings,
                             arguments.inflections, arguments.picture})
        if (!path.empty()) require_place_for_file(path);
    arguments.curves.require_places();
    if (arguments.contours && arguments.curves.files().empty())
        throw Error("", "--contours", "needs a file of --curves");
    if (!arguments.picture.empty() && arguments.picture.extension() != ".png")
        throw Error(arguments.picture.string(), "", "--picture makes a .png");
}

/// Files of the lines, with the contours of their views if requested.
void write_curves(const LinesArguments& arguments, const Scene& scene, const LineList& list,
                  const Job& job) {
    if (arguments.curves.files().empty()) return;
    CurveSet set = line_curves(list);
    if (arguments.contours)
        for (NamedCurve& curve :
             view_contours(scene, list, arguments.options.lines.lines.chord_error, job))
            set.curves.push_back(std::move(curve));
    for (const auto& file : arguments.curves.files())
        write_text_file(file, curve_output(set, file, load_options(arguments.scene), job));
}

void write(const LinesArguments& arguments, const Scene& scene, const LineList& list,
           const Job& job) {
    if (!arguments.picture.empty())
        for (std::size_t view = 0; view < list.views.size(); ++view)
            write_png(picture_of(arguments.picture, list, list.views[view]),
                      lines_picture(scene, arguments.options, list, view, job));
    write_text_file(arguments.output, lines_json(list, scene.model));
    write_curves(arguments, scene, list, job);
    if (!arguments.csv.empty()) write_text_file(arguments.csv, lines_csv(list, scene.model));
    if (!arguments.crossings.empty()) write_text_file(arguments.crossings, crossings_csv(list));
    if (!arguments.inflections.empty())
        write_text_file(arguments.inflections, line_inflections_csv(list));
}

void withdraw_earlier(const LinesArguments& arguments) {
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.insert(inputs.end(), arguments.options.views.begin(), arguments.options.views.end());
    inputs.push_back(arguments.rig);
    inputs.emplace_back(arguments.preset);
    std::vector<std::filesystem::path> outputs = arguments.curves.files();
    outputs.insert(outputs.end(), {arguments.output, arguments.csv, arguments.crossings,
                                   arguments.inflections, arguments.picture});
    withdraw_results({.files = outputs, .folders = {}}, inputs);
}

int lines(LinesArguments arguments, const Job& job) {
    require_outputs(arguments);
    withdraw_earlier(arguments);
    LinesOptions& options = arguments.options;
    if (!arguments.preset.empty()) options.preset = preset_by_name_or_file(arguments.preset);
    options.scope = arguments.scope.scope();
    require_view_names(options.views);
    if (!arguments.rig.empty()) {
        options.rig = arguments.rig;
        read_rig_aloud(arguments.rig); // a misspelt key is reported before the long work
    }
    constexpr double opening = 1, following = 3;
    JobSteps steps(job, opening + following);
    const Scene scene = arguments.scene.open(steps.next_of_steps(opening));
    arguments.scene.warn_of_axes(scene, options.views);
    const LineList list = find_lines(scene, options, steps.next_of_steps(following));
    write(arguments, scene, list, job);
    print_summary(list, arguments);
    return verdict_of(list) == Verdict::pass ? exit_pass : exit_findings;
}

} // namespace

void add_lines(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<LinesArguments>();
    CLI::App& command = *app.add_subcommand(
        "lines", "find the reflection lines of lamps and judge them where they cross seams");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_picture_size(command);
    command.add_option("--rig", arguments->rig, "rig file [the scene's own]");
    command
        .add_option("--view", arguments->options.views,
                    "view by name, or auto; may repeat [the scene's own, or auto]")
        ->allow_extra_args(false);
    command
        .add_option_function<std::string>(
            "--look",
            [arguments](const std::string& name) {
                arguments->options.lines.look = looks.at(name);
            },
            "reflection, highlight or isophote [reflection]")
        ->check(CLI::IsMember({"reflection", "highlight", "isophote"}))
        ->option_text("NAME");
    command
        .add_option("--chord", arguments->options.lines.lines.chord_error,
                    "mm between a curve and the chords of its points")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command.add_option("--preset", arguments->preset,
                       "limits by name, or a preset file (.toml) [class-a-outer]");
    command.add_option("--join", arguments->options.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    arguments->scope.add_to(command);
    command.add_option("-o,--output", arguments->output, "JSON file to write")->required();
    command.add_option("--csv", arguments->csv, "CSV file of the points to write as well");
    command.add_option("--crossings", arguments->crossings,
                       "CSV file of the crossings of lines and seams to write as well");
    command.add_option("--inflections", arguments->inflections,
                       "CSV file of the places where lines turn over to write as well");
    arguments->curves.add_to(command,
                             "STEP or IGES file of the lines as B-splines, or .vtp of "
                             "polylines, to write as well; may repeat");
    command.add_flag("--contours", arguments->contours,
                     "contours of the views, hidden ones too, among the --curves");
    command.add_option("--picture", arguments->picture,
                       "PNG file of the stripes, lines and crossings to write as well");
    command.add_option("--rows", arguments->rows, "worst crossings to print")
        ->capture_default_str();
    command.footer(
        "Exit codes: 0 all crossings pass, 1 one fails or is undecided, 2 error, 130 interrupted.\n"
        "Example: keiko lines hood.step --rig lightrigs/tunnel-12.toml -o hood-lines.json");
    session.add_command(command, [arguments](const Job& job) { return lines(*arguments, job); });
}

} // namespace keiko::cli
