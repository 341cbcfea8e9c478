#include "keiko/api/inspect.h"

#include "keiko/api/results.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/log.h"
#include "keiko/base/text.h"
#include "keiko/cli/inspection_options.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/scope_options.h"
#include "keiko/cli/session.h"
#include "keiko/cli/shard_option.h"

#include <array>
#include <cstdio>
#include <memory>

namespace keiko::cli {
namespace {

struct InspectArguments {
    SceneArguments scene;
    InspectOptions options;
    std::string rig = "auto", preset, aovs;
    std::filesystem::path output = "keiko-out";
    InspectionFiles files;
    std::filesystem::path hits;
    CombArguments combs;
    SymmetryOption symmetry;
    AcceptedOption accepted;
    ScopeOptions scope;
    ShardOption shard;
};

/// Counts of a report in words.
std::string report_words(const Report& report) {
    std::string words = seams_words(report.inspection);
    if (report.lines) {
        const CrossingCounts crossings = count_crossings(*report.lines);
        words += "; lines " + std::to_string(crossings.fail) + " fail, " +
                 std::to_string(crossings.undecided) + " undecided, " +
                 std::to_string(crossings.pass) + " pass";
    }
    if (const std::size_t accepted = whole_inspection(report).accepted.size(); accepted > 0)
        words += "; " + counted(accepted, "finding") + " accepted";
    if (const std::string part = scope_words(report.inspection.scope); !part.empty())
        words += "; " + part;
    return words;
}

void print_summary(const Report& report, const std::filesystem::path& folder) {
    TextLines lines;
    lines.line() << name_of(verdict_of(report)) << ": " << report_words(report) << "; see "
                 << (folder / "report.html").string();
    print(lines.text());
    print_scope(report.inspection.scope, report.inspection.preset);
}

void withdraw_earlier(const InspectArguments& arguments) {
    require_place_for_folder(arguments.output);
    if (!arguments.hits.empty()) require_place_for_file(arguments.hits);
    arguments.files.require_places(arguments.scene.inputs);
    ResultPlaces places{.files = arguments.files.paths(), .folders = {arguments.output}};
    places.files.push_back(arguments.hits);
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.insert(inputs.end(), arguments.options.views.begin(), arguments.options.views.end());
    if (!arguments.accepted.file().empty()) {
        inputs.push_back(arguments.accepted.file());
        require_distinct(arguments.files.paths(), {&arguments.accepted.file(), 1});
    }
    inputs.emplace_back(arguments.rig);
    inputs.emplace_back(arguments.preset);
    inputs.push_back(arguments.scene.analysis);
    withdraw_results(places, inputs);
}

/// Prints the notes of the analysis, each with the face that it lies on in this body.
void print_notes(const Scene& scene) {
    if (!scene.analysis) return;
    TextLines lines;
    for (const auto& [text, place, face] : scene.analysis->analysis.notes) {
        std::array<char, 128> at{};
        std::snprintf(at.data(), at.size(), "%.2f, %.2f, %.2f mm", place.x, place.y, place.z);
        lines.line() << "note on " << (face > 0 ? "face " + std::to_string(face) : "no face")
                     << " at " << at.data() << ": " << text;
    }
    print(lines.text());
}

/// Makes the options of an inspection whole, from all that was given.
void resolve_options(InspectArguments& arguments) {
    InspectOptions& options = arguments.options;
    arguments.scene.read_analysis();
    if (!arguments.preset.empty()) options.preset = preset_by_name_or_file(arguments.preset);
    arguments.symmetry.apply_to(options.preset);
    options.symmetry = arguments.symmetry.choice();
    options.acceptances = arguments.accepted.list();
    if (is_preset_path(arguments.preset)) options.settings.emplace_back(arguments.preset);
    if (!arguments.accepted.file().empty()) options.settings.push_back(arguments.accepted.file());
    options.scope = arguments.scope.scope();
    if (arguments.rig != "auto") {
        options.rig = arguments.rig;
        read_rig_aloud(*options.rig); // a misspelt key is reported before the long work
    }
    require_view_names(options.views, arguments.scene.options.analysis);
    options.combs = arguments.combs.options(options.join);
    options.picture.aovs = aovs_by_names(arguments.aovs);
    if (!options.picture.aovs.empty()) options.picture.light_error = PictureOptions().light_error;
    options.register_hits = !arguments.hits.empty();
}

/// An opened body and what was found on it.
struct InspectedScene {
    Scene scene;
    InspectResult result;
};

InspectedScene inspect_models(const InspectArguments& arguments, const Job& job) {
    constexpr double opening = 1, inspecting = 9;
    JobSteps steps(job, opening + inspecting);
    Scene scene = arguments.scene.open(steps.next_of_steps(opening));
    arguments.scene.warn_of_axes(scene, arguments.options.views);
    InspectResult result = inspect_scene(scene, arguments.options, steps.next_of_steps(inspecting));
    return {std::move(scene), std::move(result)};
}

void warn_of(const InspectResult& result, const Inspection& whole) {
    warn_of_acceptances(whole);
    if (const std::string warning = nothing_judged(result.report.inspection); !warning.empty())
        log_warning(warning);
    if (const std::string warning = joints_not_judged(whole); !warning.empty())
        log_warning(warning);
    if (result.combs) log_warnings(result.combs->remarks);
}

int inspect(InspectArguments arguments, const Job& job) {
    withdraw_earlier(arguments);
    resolve_options(arguments);
    const auto [scene, result] = inspect_models(arguments, job);
    FileTransaction outputs;
    outputs.add_folder(arguments.output, with_manifest(result_files(arguments.output, result)));
    if (result.hits) outputs.add(arguments.hits, hits_text(*result.hits));
    const Inspection whole = whole_inspection(result.report);
    arguments.files.add_to(outputs, whole);
    outputs.write();
    warn_of(result, whole);
    print_summary(result.report, arguments.output);
    print_notes(scene);
    return verdict_of(result.report) == Verdict::pass ? exit_pass : exit_findings;
}

PartResult inspect_part(InspectArguments arguments, const std::filesystem::path& model,
                        const std::filesystem::path& folder, const Job& job) {
    arguments.scene.inputs = {model};
    const InspectResult result = inspect_models(arguments, job).result;
    warn_of(result, whole_inspection(result.report));
    return {part_state(verdict_of(result.report)), report_words(result.report), "report.html",
            result_files(folder, result)};
}

/// Inspects a shard of the models; each is a body.
int inspect_shard(InspectArguments arguments, const CLI::App& command, const Job& job) {
    require_place_for_folder(arguments.output);
    resolve_options(arguments);
    PartsOptions parts =
        parts_options(command, arguments.shard, arguments.scene.inputs, arguments.output);
    parts.load = arguments.scene.scene_options().load;
    parts.settings += arguments.accepted.day();
    const JudgePart judge = [&](const std::filesystem::path& model,
                                const std::filesystem::path& folder, const Job& inner) {
        return inspect_part(arguments, model, folder, inner);
    };
    return tell_parts(run_parts(parts, judge, arguments.shard.job(job)), arguments.output);
}

} // namespace

void add_inspect(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<InspectArguments>();
    CLI::App& command = *app.add_subcommand(
        "inspect",
        "place lamps, render their reflections, measure seams and lines, write a report");
    arguments->scene.add_to(command, "MODEL");
    arguments->scene.add_picture_size(command);
    arguments->scene.add_shadows(command);
    arguments->scene.add_analysis(command);
    command.add_option("-o,--output", arguments->output, "folder for the report")
        ->capture_default_str();
    command
        .add_option("--view", arguments->options.views,
                    "view by name, or auto; may repeat [three automatic ones]")
        ->allow_extra_args(false);
    command
        .add_option("--aov", arguments->aovs,
                    "writes each picture as an .exr, too, with these layers, comma-separated: "
                    "luminance, normal, uv, face, patch, depth, c_plane_uv, illuminance, curvature")
        ->check(not_empty());
    command
        .add_option("--close-ups", arguments->options.close_ups,
                    "close-up pictures at most: first the faults to mend first, then the worst")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    command.add_option("--rig", arguments->rig, "rig file, or auto: place the lamps")
        ->capture_default_str();
    command.add_option("--preset", arguments->preset,
                       "limits by name, or a preset file (.toml) [class-a-outer]");
    command.add_option("--join", arguments->options.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command.add_flag("--joints", arguments->options.joints,
                     "gap and flush between panels that stand apart, by the preset's [joint]");
    arguments->files.add_to(command);
    arguments->combs.add_to(command);
    arguments->symmetry.add_to(command, true);
    arguments->accepted.add_to(command);
    arguments->scope.add_to(command);
    command.add_option("--register", arguments->hits,
                       "file (.json) for what the pictures mirror, for keiko place --from");
    arguments->shard.add_to(command, shard_of_models,
                            {"--junit", "--sarif", "--csv", "--register"});
    command.footer("Example: keiko inspect fender.step -o out --view three-quarter-front");
    session.add_command(command, [arguments, &command](const Job& job) {
        return arguments->shard.requested() ? inspect_shard(*arguments, command, job)
                                            : inspect(*arguments, job);
    });
}

} // namespace keiko::cli
