#include "keiko/api/compare.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/log.h"
#include "keiko/base/output_folder.h"
#include "keiko/cli/compare_scan.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/scope_options.h"
#include "keiko/cli/session.h"

#include <array>
#include <memory>

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

struct CompareArguments {
    SceneArguments scene; ///< without its inputs
    fs::path before, after, output, json, junit;
    CompareBodiesOptions options;
    CompareViewsOptions views;
    std::string preset, rig = "auto", mirror;
    ScopeOptions scope;
    ScanArguments scan; ///< without what bodies have too
};

bool shows_pictures(const CompareArguments& arguments) {
    return !arguments.output.empty() || !arguments.views.views.empty() || arguments.rig != "auto" ||
           !arguments.scene.analysis.empty();
}

void require_outputs(const CompareArguments& arguments) {
    std::vector<fs::path> files{arguments.json, arguments.junit};
    const fs::path& output = arguments.output;
    if (is_page(output)) {
        files.push_back(output);
    } else if (!output.empty()) {
        require_place_for_folder(output);
        for (const char* name : {"compare.html", "compare.json", "rig.toml"})
            files.push_back(output / name);
    }
    const std::array inputs{arguments.before, arguments.after};
    require_distinct(files, inputs);
    for (const fs::path& file : {arguments.json, arguments.junit, is_page(output) ? output : ""})
        if (!file.empty()) require_place_for_file(file);
}

void write_outputs(const CompareArguments& arguments, const CompareResult& result) {
    const Comparison& comparison = result.comparison;
    FileTransaction batch;
    if (is_page(arguments.output))
        batch.add(arguments.output, comparison_html(comparison));
    else if (!arguments.output.empty())
        batch.add_folder(arguments.output,
                         with_manifest(comparison_files(arguments.output, result)));
    if (!arguments.json.empty()) batch.add(arguments.json, comparison_json(comparison));
    if (!arguments.junit.empty()) batch.add(arguments.junit, comparison_junit(comparison));
    batch.write();
}

CompareBodiesOptions options_of(const CompareArguments& arguments) {
    CompareBodiesOptions options = arguments.options;
    if (!arguments.preset.empty()) options.preset = preset_by_name_or_file(arguments.preset);
    options.scene = arguments.scene.scene_options();
    options.scope = arguments.scope.scope();
    if (!arguments.mirror.empty()) options.mirror = MirrorPlane::parse(arguments.mirror);
    if (!shows_pictures(arguments)) return options;
    options.views = arguments.views;
    require_view_names(options.views->views, options.scene.analysis);
    const PictureSize size = arguments.scene.picture_size();
    options.views->width = size.width, options.views->height = size.height;
    if (arguments.rig == "auto") return options;
    options.views->rig = arguments.rig;
    read_rig_aloud(arguments.rig); // a misspelt key is reported before the long work
    return options;
}

void withdraw_earlier(const CompareArguments& arguments) {
    ResultPlaces places{.files = {arguments.json, arguments.junit}, .folders = {}};
    (is_page(arguments.output) ? places.files : places.folders).push_back(arguments.output);
    std::vector<fs::path> inputs{arguments.before, arguments.after, arguments.rig, arguments.preset,
                                 arguments.scene.analysis};
    inputs.insert(inputs.end(), arguments.views.views.begin(), arguments.views.views.end());
    withdraw_results(places, inputs);
}

void warn_of_lost_faces(const Comparison& comparison) {
    for (const Inspection* inspection :
         {&comparison.inspection_before, &comparison.inspection_after})
        for (const LostFace& face : inspection->facts.lost_faces)
            log_warning(inspection->facts.source + ": face " + std::to_string(face.id) +
                        " is missing: " + face.reason);
}

/// Compares a scan, by its own options and those that bodies have too.
int compare_scan(const CLI::App& command, const CompareArguments& arguments, const Job& job) {
    SceneArguments nominal = arguments.scene;
    nominal.inputs = {arguments.before};
    ScanArguments scan = arguments.scan;
    scan.scan = arguments.after, scan.output = arguments.output, scan.json = arguments.json;
    scan.views = arguments.views.views, scan.reach = arguments.options.reach;
    scan.tolerance = arguments.options.tolerance.deviation;
    return compare_with_scan(command, nominal, scan, job);
}

int compare(const CLI::App& command, CompareArguments arguments, const Job& job) {
    const bool is_scan = is_scan_file(arguments.after) || arguments.scan.surface;
    if (is_scan_file(arguments.after) && arguments.scan.surface)
        throw Error("", "--iso", "is for voxels, not for points");
    require_options_of_kind(command, is_scan);
    if (is_scan) return compare_scan(command, arguments, job);
    if (arguments.after.empty() && arguments.mirror.empty())
        throw Error("", "AFTER", "is missing: name the revision, or a plane to --mirror at");
    if (arguments.after.empty()) arguments.after = arguments.before;
    require_outputs(arguments);
    withdraw_earlier(arguments);
    arguments.scene.read_analysis();
    const CompareBodiesOptions options = options_of(arguments);
    const CompareResult result = compare_bodies(arguments.before, arguments.after, options, job);
    const Comparison& comparison = result.comparison;
    warn_of_lost_faces(comparison);
    log_remarks(result.remarks);
    write_outputs(arguments, result);
    print(comparison_text(comparison));
    return comparison.same() ? exit_pass : exit_findings;
}

void add_outputs(CLI::App& command, CompareArguments& arguments) {
    command.add_option(
        "-o,--output", arguments.output,
        "folder for the report, or a page FILE.html (or .htm); views are shown and judged");
    command.add_option("--json", arguments.json, "JSON file to write (keiko-comparison/1)");
    command.add_option("--junit", arguments.junit, "JUnit XML file to write");
    command
        .add_option("--view", arguments.views.views,
                    "view by name, or auto; may repeat [three automatic ones of BEFORE]")
        ->allow_extra_args(false);
    command
        .add_option("--rig", arguments.rig,
                    "rig file, or auto: place the lamps on BEFORE; the same for both")
        ->capture_default_str();
}

void add_tolerances(CLI::App& command, CompareBodiesOptions& options) {
    const auto add = [&](const char* name, double& value, double least, double most,
                         const char* text) {
        command.add_option(name, value, text)
            ->check(number_between(least, most))
            ->capture_default_str();
    };
    add("--join", options.join, 1e-6, 1000, "mm within which borders are a seam");
    add("--tolerance", options.tolerance.deviation, 0, 1e6,
        "mm that surfaces may be apart and still be the same, or the points of a scan off; without "
        "it a scan is not judged");
    add("--border-tolerance", options.tolerance.border, 0, 1e6,
        "mm that borders may be apart and still be the same");
    add("--angle-tolerance", options.tolerance.normal, 0, 180,
        "degrees that their normals may be apart");
    add("--line-tolerance", options.tolerance.line, 0, 1e6,
        "mm that reflection lines may move on the part");
    add("--outline-tolerance", options.tolerance.outline, 0, 1e6,
        "mm that outlines in pictures may move on the part, or the next, whichever is more");
    add("--outline-pixels", options.tolerance.outline_pixels, 0, 1e6,
        "pixels that outlines may move in pictures");
    add("--place", options.seams.place, 1e-6, 1e6,
        "mm that a seam may have moved and still be the same seam");
}

void add_sampling(CLI::App& command, CompareBodiesOptions& options) {
    command
        .add_option("--reach", options.reach,
                    "mm that distances are sought within; what is further away is told as that "
                    "[a fiftieth of the size of BEFORE]")
        ->check(number_between(1e-9, 1e9));
    command
        .add_option("--samples", options.deviation.samples,
                    "about how many places of a body deviations are measured at, and sought from")
        ->check(number_between(1, 1e8))
        ->capture_default_str();
}

} // namespace

void add_compare(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App& command = *app.add_subcommand(
        "compare", "tell how a revision of a part, or its scan, deviates from the one before");
    command.add_option("BEFORE", arguments->before, "model file, or scene file (.toml)")
        ->required();
    command.add_option(
        "AFTER", arguments->after,
        "model or scene file, in the same coordinates [with --mirror: BEFORE], or the "
        "scan of a part: .stl, .ply, .asc or .xyz");
    command.add_option("--mirror", arguments->mirror,
                       "take the mirror image of AFTER at a plane: x, y, z, or y=12.5 (mm)");
    command.add_flag("--align", arguments->options.align,
                     "move AFTER onto BEFORE first, by least squares of their distance");
    arguments->scan.add_to(command);
    add_outputs(command, *arguments);
    command.add_option("--preset", arguments->preset,
                       "limits by name, or a preset file (.toml) [class-a-outer]");
    arguments->scope.add_to(command);
    add_tolerances(command, arguments->options);
    add_sampling(command, arguments->options);
    arguments->scene.add_picture_size(command);
    arguments->scene.add_shadows(command);
    arguments->scene.add_analysis(command);
    arguments->scene.add_reading(command);
    command.footer(
        "Exit codes: 0 same within tolerance, 1 different, 2 error, 130 interrupted.\n"
        "Example: keiko compare fender-a.step fender-b.step -o out\n"
        "Example: keiko compare fender.step fender-scan.stl --tolerance 0.2 -o out");
    session.add_command(command, [arguments, &command](const Job& job) {
        return compare(command, *arguments, job);
    });
}

} // namespace keiko::cli
