
#include "keiko/api/regress.h"

#include "keiko/base/error.h"
#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/scene_options.h"
#include "keiko/cli/session.h"
#include "keiko/cli/shard_option.h"

#include <memory>

namespace keiko::cli {
namespace {

struct RegressArguments {
    RegressOptions options;
    SceneArguments loading;
    ShardOption shard;
    std::vector<std::string> update;
    std::string by, reason;
};

int exit_code_of(FixtureState state) {
    if (state == FixtureState::error) return exit_error;
    return state == FixtureState::same ? exit_pass : exit_findings;
}

/// "high-front: color", the first view and layer that exceed their tolerance; else empty.
std::string worst_picture(const FixtureOutcome& fixture) {
    for (const PictureOutcome& picture : fixture.pictures) {
        if (picture.within()) continue;
        if (!picture.problem.empty()) return picture.view + " " + picture.problem;
        std::string layers = picture.flips_within ? "" : "silhouette";
        for (const LayerDifference& layer : picture.layers)
            if (!layer.within) layers += (layers.empty() ? "" : ", ") + layer.layer;
        return picture.view + ": " + layers;
    }
    return "";
}

std::string line_of(const FixtureOutcome& fixture) {
    std::string text(name_of(fixture.state));
    text += " " + fixture.name;
    if (fixture.state == FixtureState::error) return text + ": " + fixture.error;
    if (fixture.state != FixtureState::different) return text;
    std::size_t views = 0;
    for (const PictureOutcome& picture : fixture.pictures) views += !picture.within();
    text += ": " + std::to_string(fixture.metrics.size()) + " of " +
            counted(fixture.metrics_compared, "metric") + ", " + std::to_string(views) + " of " +
            counted(fixture.pictures.size(), "view");
    if (!fixture.metrics.empty()) text += "; " + text_of(fixture.metrics.front());
    if (const std::string picture = worst_picture(fixture); !picture.empty())
        text += "; " + picture;
    return text;
}

int tell(const Regression& regression, const std::filesystem::path& output) {
    TextLines lines;
    for (const FixtureOutcome& fixture : regression.fixtures) lines.line() << line_of(fixture);
    for (const std::string& name : regression.stale_baselines)
        lines.line() << "stale baseline " << name << ": no fixture has this name";
    if (regression.count(FixtureState::missing) > 0)
        lines.line() << "inspect the candidates of missing baselines, then accept them with "
                        "keiko regress --update NAME";
    lines.line() << summary_of(regression) << "; see " << (output / "index.html").string();
    print(lines.text());
    return exit_code_of(regression.state());
}

int update(const RegressArguments& arguments, const RegressOptions& options, const Job& job) {
    const std::string by = arguments.by.empty() ? login_name() : arguments.by;
    TextLines lines;
    for (const AcceptedBaseline& accepted :
         update_baselines(options, arguments.update, by, arguments.reason, job)) {
        lines.line() << (accepted.change.changed.empty() ? "unchanged " : "accepted ")
                     << accepted.name;
        for (const std::string& change : accepted.change.changed) lines.line() << "  " << change;
    }
    print(lines.text());
    return exit_pass;
}

int regress(const RegressArguments& arguments, const Job& job) {
    RegressOptions options = arguments.options;
    if (arguments.shard.requested()) options.shard = arguments.shard.shard();
    options.load = load_options(arguments.loading);
    require_place_for_folder(options.output);
    if (!arguments.update.empty()) return update(arguments, options, job);
    const std::filesystem::path folder =
        options.shard ? shard_folder(options.output, options.shard->number) : options.output;
    return tell(run_regression(options, arguments.shard.job(job)), folder);
}

/// `only` and `shard` are the options that exclude it.
void add_updating(CLI::App& command, RegressArguments& arguments, CLI::Option* only,
                  CLI::Option* shard) {
    auto* update = command
                       .add_option("--update", arguments.update,
                                   "accept what this fixture shows now as its baseline; may repeat")
                       ->allow_extra_args(false)
                       ->excludes(only)
                       ->excludes(shard);
    command.add_option("--reason", arguments.reason, "why, for the baseline's manifest")
        ->needs(update);
    command.add_option("--by", arguments.by, "who, for the manifest [your login name]")
        ->needs(update);
}

} // namespace

void add_regress(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<RegressArguments>();
    RegressOptions& options = arguments->options;
    CLI::App& command = *app.add_subcommand(
        "regress", "run the fixtures of a folder and hold them against their baselines");
    command.add_option("DIR", options.suite, "folder with fixtures (keiko-fixture/1)")->required();
    command.add_option("-o,--output", options.output, "folder for candidates and reports")
        ->capture_default_str();
    command.add_option("--baseline", options.baselines, "folder of the baselines [DIR/baselines]");
    auto* only = command.add_option("--only", options.only, "run this fixture; may repeat [all]")
                     ->allow_extra_args(false);
    auto* shard = arguments->shard.add_to(
        command,
        "K/N: run the K-th of N shares of about the same cost, into OUTPUT/shard-K; auto, "
        "auto/N: the share of this task of an array job; see merge");
    command.add_flag("--fresh", options.fresh,
                     "run fixtures again that an earlier run has finished");
    add_updating(command, *arguments, only, shard);
    add_load_options(command, arguments->loading);
    command.footer(
        "Exit codes: 0 all the same, 1 different or no baseline, 2 error, 130 interrupted.\n"
        "Example: keiko regress surfaces -o out --shard 1/4");
    session.add_command(command, [arguments](const Job& job) { return regress(*arguments, job); });
}

namespace {

struct MergeArguments {
    std::vector<std::filesystem::path> shards;
    std::filesystem::path output;
};

/// Folder of the reports: by default the one that has the shards in it.
std::filesystem::path merged_folder(const MergeArguments& arguments) {
    if (!arguments.output.empty()) return arguments.output;
    if (arguments.shards.size() == 1) return arguments.shards.front();
    throw FieldError("output", "is needed where several folders are joined");
}

int merge(const MergeArguments& arguments) {
    const std::filesystem::path output = merged_folder(arguments);
    require_place_for_folder(output);
    for (const std::filesystem::path& folder : arguments.shards) {
        if (!holds_parts(folder)) continue;
        if (arguments.shards.size() > 1 || output != folder)
            throw FieldError("output",
                             "is not for a run of check or inspect, whose report lies "
                             "beside its parts: keiko merge " +
                                 folder.string());
        return tell_parts(merge_parts(folder), folder / "index.html");
    }
    return tell(merge_regressions(arguments.shards, output), output);
}

} // namespace

void add_merge(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<MergeArguments>();
    CLI::App& command = *app.add_subcommand(
        "merge", "join the shards of regress, check or inspect into one report");
    command
        .add_option("FOLDER", arguments->shards,
                    "output folder of a run with --shard, or its shards one by one")
        ->required();
    command.add_option("-o,--output", arguments->output,
                       "folder for the reports [FOLDER, if it is one]");
    command.footer(
        "Exit codes: those of the joined run; 2 if a shard is missing.\n"
        "Example: keiko merge out");
    session.add_command(command, [arguments](const Job&) { return merge(*arguments); });
}

} // namespace keiko::cli
