#include "keiko/api/check.h"

#include "keiko/api/lines.h"
#include "keiko/api/results.h"
#include "keiko/base/log.h"
#include "keiko/cli/inspection_options.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/scope_options.h"
#include "keiko/cli/session.h"
#include "keiko/cli/shard_option.h"

#include <memory>

namespace keiko::cli {
namespace {

struct CheckArguments {
    SceneArguments models; ///< only inputs and load options
    CheckOptions options;
    std::string preset;
    InspectionFiles files;
    CombArguments combs;
    CurveFilesOption curves;
    ProfileArguments profiles;
    SymmetryOption symmetry;
    AcceptedOption accepted;
    ScopeOptions scope;
    ShardOption shard;
};

void withdraw_earlier(const CheckArguments& arguments) {
    arguments.files.require_places(arguments.models.inputs);
    arguments.curves.require_places();
    arguments.combs.require_places(!arguments.curves.files().empty());
    arguments.profiles.require_places();
    ResultPlaces places{.files = arguments.files.paths(), .folders = {}};
    const auto& combs = arguments.combs.files();
    places.files.insert(places.files.end(), combs.begin(), combs.end());
    const auto& curves = arguments.curves.files();
    places.files.insert(places.files.end(), curves.begin(), curves.end());
    const auto& profiles = arguments.profiles.files();
    places.files.insert(places.files.end(), profiles.begin(), profiles.end());
    std::vector<std::filesystem::path> inputs = arguments.models.inputs;
    if (!arguments.accepted.file().empty()) inputs.push_back(arguments.accepted.file());
    require_distinct(places.files, inputs);
    inputs.emplace_back(arguments.preset);
    withdraw_results(places, inputs);
}

/// Files of the sections, the iso-curves and the inflections.
void add_curves(FileTransaction& outputs, const CheckArguments& arguments,
                const CheckResult& result, const Job& job) {
    if (arguments.curves.files().empty()) return;
    const CurveSet curves = check_curves(result, arguments.options);
    for (const auto& file : arguments.curves.files())
        outputs.add(file, curve_output(curves, file, arguments.options.load, job));
}

/// The options of a check, as they were given.
CheckOptions check_options(const CheckArguments& arguments) {
    CheckOptions options = arguments.options;
    if (!arguments.preset.empty()) options.preset = preset_by_name_or_file(arguments.preset);
    arguments.symmetry.apply_to(options.preset);
    arguments.symmetry.look_in(options.preset);
    options.acceptances = arguments.accepted.list();
    options.scope = arguments.scope.scope();
    options.load = load_options(arguments.models);
    options.combs = arguments.combs.options(options.join);
    options.profiles = !arguments.profiles.files().empty();
    return options;
}

void warn_of(const Inspection& inspection) {
    for (const LostFace& face : inspection.facts.lost_faces)
        log_warning("face " + std::to_string(face.id) + " is missing: " + face.reason);
    if (const std::string warning = nothing_judged(inspection); !warning.empty())
        log_warning(warning);
    if (const std::string warning = joints_not_judged(inspection); !warning.empty())
        log_warning(warning);
    warn_of_acceptances(inspection);
}

int check(CheckArguments arguments, const Job& job) {
    withdraw_earlier(arguments);
    arguments.options = check_options(arguments);
    const CheckResult result = check_models(arguments.models.inputs, arguments.options, job);
    const Inspection& inspection = result.inspection;
    warn_of(inspection);
    FileTransaction outputs;
    arguments.files.add_to(outputs, inspection);
    if (result.combs) arguments.combs.add_to(outputs, *result.combs);
    arguments.profiles.add_to(outputs, result);
    add_curves(outputs, arguments, result, job);
    outputs.write();
    if (result.combs) log_warnings(result.combs->remarks);
    print(inspection_text(inspection));
    return inspection.verdict == Verdict::pass ? exit_pass : exit_findings;
}

PartResult check_part(const CheckOptions& options, const std::filesystem::path& model,
                      const Job& job) {
    const Inspection inspection = check_models({&model, 1}, options, job).inspection;
    warn_of(inspection);
    return {part_state(inspection.verdict), seams_words(inspection), "inspection.json",
            InspectionFiles::every_format(inspection)};
}

/// Checks a shard of the models; each is a body.
int check_shard(const CheckArguments& arguments, const CLI::App& command, const Job& job) {
    const std::filesystem::path output = arguments.files.folder();
    require_place_for_folder(output);
    const CheckOptions options = check_options(arguments);
    PartsOptions parts = parts_options(command, arguments.shard, arguments.models.inputs, output);
    parts.load = options.load;
    parts.settings += arguments.accepted.day();
    const JudgePart judge = [&](const std::filesystem::path& model, const std::filesystem::path&,
                                const Job& inner) { return check_part(options, model, inner); };
    return tell_parts(run_parts(parts, judge, arguments.shard.job(job)), output);
}

} // namespace

void add_check(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App& command = *app.add_subcommand(
        "check", "hold the geometry of a body against criteria, without lamps or pictures");
    command
        .add_option("MODEL", arguments->models.inputs,
                    "model files of one body, or one scene file (.toml)")
        ->required();
    command.add_option("--preset", arguments->preset,
                       "limits by name, or a preset file (.toml) [class-a-outer]");
    command.add_option("--join", arguments->options.join, "mm within which borders are a seam")
        ->check(number_between(1e-6, 1000))
        ->capture_default_str();
    command.add_flag("--joints", arguments->options.joints,
                     "gap and flush between panels that stand apart, by the preset's [joint]");
    arguments->files.add_json_and_output(command);
    arguments->files.add_to(command);
    arguments->combs.add_to(command);
    arguments->symmetry.add_to(command, false);
    arguments->accepted.add_to(command);
    arguments->scope.add_to(command);
    arguments->combs.add_files(command);
    arguments->curves.add_to(command,
                             "STEP or IGES file to write sections, iso-curves, "
                             "inflections of faces and seams to, as B-splines, or .vtp of "
                             "polylines; may repeat");
    arguments->profiles.add_to(command);
    arguments->shard.add_to(
        command, shard_of_models,
        {"--json", "--junit", "--sarif", "--csv", "--combs", "--curves", "--profiles"});
    add_load_options(command, arguments->models);
    command.footer(
        "Exit codes: 0 all pass, 1 lost faces or findings that are not accepted, 2 error.\n"
        "Example: keiko check fender.step door.step --preset vda-4955 --sarif findings.sarif");
    session.add_command(command, [arguments, &command](const Job& job) {
        return arguments->shard.requested() ? check_shard(*arguments, command, job)
                                            : check(*arguments, job);
    });
}

} // namespace keiko::cli
