#include "keiko/cli/compare_scan.h"

#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/output_folder.h"
#include "keiko/base/text.h"
#include "keiko/base/units.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/session.h"

#include <array>

namespace keiko::cli {
namespace fs = std::filesystem;
namespace {

void require_outputs(const SceneArguments& scene, const ScanArguments& arguments) {
    std::vector<fs::path> files{arguments.json};
    const fs::path& output = arguments.output;
    if (is_page(output)) {
        files.push_back(output);
    } else if (!output.empty()) {
        require_place_for_folder(output);
        for (const char* name : {"compare.html", "compare.json"}) files.push_back(output / name);
    }
    const std::array inputs{scene.inputs.front(), arguments.scan};
    require_distinct(files, inputs);
    for (const fs::path& file : {arguments.json, is_page(output) ? output : ""})
        if (!file.empty()) require_place_for_file(file);
    ResultPlaces places{.files = {arguments.json}, .folders = {}};
    (is_page(output) ? places.files : places.folders).push_back(output);
    std::vector<fs::path> used(inputs.begin(), inputs.end());
    used.insert(used.end(), arguments.views.begin(), arguments.views.end());
    withdraw_results(places, used);
}

CompareScanOptions options_of(const CLI::App& command, const SceneArguments& scene,
                              const ScanArguments& arguments) {
    CompareScanOptions options;
    options.scan = arguments.scan.string();
    if (command.count("--tolerance") > 0)
        options.limits.tolerance = arguments.tolerance;
    else if (command.count("--least-share") > 0)
        throw Error("", "--least-share", "needs a --tolerance that the points are held to");
    options.limits.least_share = arguments.least_share / 100;
    options.align = !arguments.stay, options.reach = arguments.reach;
    if (arguments.output.empty() && !arguments.views.empty())
        throw Error("", "--view", "needs -o, the page or folder of its pictures");
    if (arguments.output.empty()) return options;
    require_view_names(arguments.views);
    const PictureSize size = scene.picture_size();
    options.views = ScanViewsOptions{arguments.views, size.width, size.height};
    return options;
}

/// The points in the coordinates of the nominal: in mm, and turned as that is.
std::vector<Vec3> points_of(const SceneArguments& scene, const ScanArguments& arguments,
                            const Job& job) {
    const auto millimetres = millimetres_per(arguments.unit);
    if (!millimetres)
        throw Error("", "--scan-unit", in_quotes(arguments.unit) + " is no length unit");
    std::vector<Vec3> points =
        arguments.surface
            ? read_voxel_surface(arguments.scan, *arguments.surface, *millimetres, job)
            : read_scan(arguments.scan, *millimetres);
    if (scene.options.load.axes.empty()) return points;
    const Affine frame = axes_frame(scene.options.load.axes);
    for (Vec3& point : points) point = frame.point(point);
    return points;
}

void write_outputs(const ScanArguments& arguments, const ScanComparison& comparison) {
    FileTransaction batch;
    if (is_page(arguments.output))
        batch.add(arguments.output, scan_html(comparison));
    else if (!arguments.output.empty())
        batch.add_folder(arguments.output, with_manifest(scan_files(comparison)));
    if (!arguments.json.empty()) batch.add(arguments.json, scan_json(comparison));
    batch.write();
}

} // namespace

void ScanArguments::add_to(CLI::App& command) {
    command.add_flag("--no-align", stay,
                     "of a scan: leave the points where they are [moved onto BEFORE first]");
    command
        .add_option("--least-share", least_share,
                    "of a scan: percent of the points that must be within --tolerance")
        ->check(number_between(0, 100))
        ->capture_default_str();
    command.add_option("--iso", surface,
                       "AFTER is a file of voxels (keiko-voxels/1): value of its surface");
    command.add_option("--scan-unit", unit, "of a scan: length unit of its numbers")
        ->capture_default_str();
}

bool is_page(const fs::path& output) {
    const std::string ending = lower_case(output.extension().string());
    return ending == ".html" || ending == ".htm";
}

void require_options_of_kind(const CLI::App& command, bool is_scan) {
    constexpr std::array of_scans{"--no-align", "--least-share", "--scan-unit"};
    constexpr std::array of_bodies{"--align",
                                   "--mirror",
                                   "--junit",
                                   "--rig",
                                   "--preset",
                                   "--faces",
                                   "--layers",
                                   "--colors",
                                   "--zone",
                                   "--join",
                                   "--place",
                                   "--border-tolerance",
                                   "--angle-tolerance",
                                   "--line-tolerance",
                                   "--samples",
                                   "--outline-tolerance",
                                   "--shadows",
                                   "--outline-pixels",
                                   "--analysis"};
    const auto refuse = [&](const auto& names, const char* reason) {
        for (const char* name : names)
            if (command.count(name) > 0) throw Error("", name, reason);
    };
    if (is_scan)
        refuse(of_bodies, "is not for scans, whose points have no seams and borders");
    else
        refuse(of_scans, "is for scans: .stl, .ply, .asc or .xyz");
}

int compare_with_scan(const CLI::App& command, const SceneArguments& scene,
                      const ScanArguments& arguments, const Job& job) {
    require_outputs(scene, arguments);
    const CompareScanOptions options = options_of(command, scene, arguments);
    const std::vector<Vec3> points = points_of(scene, arguments, job);
    constexpr double opening = 1, comparing = 4;
    JobSteps steps(job, opening + comparing);
    const Scene nominal = scene.open(steps.next_of_steps(opening));
    const ScanComparison comparison =
        compare_points(nominal, points, options, steps.next_of_steps(comparing)).comparison;
    write_outputs(arguments, comparison);
    print(scan_text(comparison));
    return comparison.passes().value_or(true) ? exit_pass : exit_findings;
}

} // namespace keiko::cli
