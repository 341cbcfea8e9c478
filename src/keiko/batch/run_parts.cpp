#include "keiko/batch/run_parts.h"

#include "keiko/base/error.h"
#include "keiko/base/input_file.h"
#include "keiko/base/log.h"
#include "keiko/base/output_file.h"
#include "keiko/base/sha256.h"
#include "keiko/batch/balanced_shards.h"
#include "keiko/batch/joined_run.h"
#include "keiko/batch/part_names.h"
#include "keiko/workflow/version.h"

#include <optional>
#include <system_error>

namespace keiko {
namespace fs = std::filesystem;
namespace {

constexpr const char* record_file = "parts.json";
constexpr const char* part_file = "part.json";

std::string key_of(const fs::path& model, const PartsOptions& options) {
    std::vector<fs::path> inputs = options.files;
    inputs.push_back(model);
    const std::string settings = options.command + "\n" + model.string() + "\n" + options.settings;
    try {
        return input_key(inputs, model.parent_path(), options.load, settings);
    } catch (const Error& error) { // it will be the part's outcome
        return sha256_hex(settings + error.what());
    }
}

ShardPlan plan_of(const PartsOptions& options) {
    const std::vector<std::string> names = part_names(options.models);
    std::vector<PlannedPart> parts;
    std::vector<double> costs;
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        parts.push_back({names[i], key_of(options.models[i], options)});
        costs.push_back(body_cost({&options.models[i], 1}));
        text += names[i] + " " + parts.back().key + "\n";
    }
    return balanced_plan(options.command, sha256_hex(text), std::move(parts), costs,
                         options.shard.count);
}

/// Outcome that an earlier run has kept; one without a name where there is none, or one of other
/// inputs, or a damaged one.
PartOutcome kept_outcome(const fs::path& folder, const std::string& key) {
    const fs::path file = folder / part_file;
    std::error_code ignored; // what cannot be read is made anew
    if (!fs::exists(file, ignored)) return {};
    try {
        return parse_part(read_file(file), key, file.string());
    } catch (const Error&) {
        return {};
    }
}

/// Keeps the results of a part, in place of those that are there.
void keep(PartResult result, const PartOutcome& outcome, const std::string& key,
          const fs::path& folder) {
    result.files[part_file] = part_json(outcome, key);
    // Another copy of this task may be writing the same.
    const FolderLock lock(folder.parent_path(), std::chrono::minutes(1));
    write_folder_atomically(folder, result.files);
}

PartOutcome outcome_of(const PlannedPart& part, const fs::path& model, const PartsOptions& options,
                       const JudgePart& judge, const Job& job) {
    const fs::path folder = options.output / part_folder(part.name);
    if (PartOutcome kept = kept_outcome(folder, part.key); kept.name == part.name) return kept;
    const WarningSubject subject(part.name);
    try {
        PartResult result = judge(model, folder, job);
        if (key_of(model, options) != part.key)
            throw Error(model.string(), "", "was changed while it was judged; run it again");
        PartOutcome outcome{part.name, model.string(), result.state, result.summary, result.page};
        keep(std::move(result), outcome, part.key, folder);
        return outcome;
    } catch (const Cancelled&) {
        throw;
    } catch (const std::exception& error) {
        return {part.name, model.string(), PartState::error, error.what()};
    }
}

std::vector<std::string> names_of(const ShardPlan& plan) {
    std::vector<std::string> names;
    for (const PlannedPart& part : plan.parts) names.push_back(part.name);
    return names;
}

} // namespace

PartsRun run_parts(const PartsOptions& options, const JudgePart& judge, const Job& job) {
    const ShardPlan plan = plan_of(options);
    claim_shard(options.output, plan, options.shard.number);
    const fs::path folder = shard_folder(options.output, options.shard.number);
    std::error_code ignored; // what cannot be removed shows when it is written
    fs::remove(folder / record_file, ignored);
    PartsRun run{.command = options.command,
                 .tool_version = plan.tool_version,
                 .key = plan.key,
                 .shard = options.shard.number,
                 .shards = options.shard.count,
                 .all = names_of(plan)};
    const std::vector<std::size_t> share = share_of(plan, options.shard.number);
    for (std::size_t i = 0; i < share.size(); ++i) {
        job.check();
        const PlannedPart& part = plan.parts[share[i]];
        run.parts.push_back(outcome_of(part, options.models[share[i]], options, judge,
                                       job_of_part(job, i, share.size(), part.name)));
    }
    require_claimed(options.output, plan);
    write_text_file(folder / record_file, parts_json(run));
    return run;
}

bool holds_parts(const fs::path& output) {
    const std::optional<ShardPlan> plan = kept_plan(output);
    return plan && plan->command != "regress";
}

PartsRun merge_parts(const fs::path& output) {
    withdraw_reports(output, record_file);
    constexpr RunMembers<PartsRun, PartOutcome> members{&PartsRun::key, &PartsRun::all,
                                                        &PartsRun::parts};
    PartsRun merged =
        joined_run(shard_folders({&output, 1}, record_file), members, [](const fs::path& folder) {
            const fs::path file = folder / record_file;
            return parse_parts(read_file(file), file.string());
        });
    const FolderLock lock(output);
    FileTransaction reports;
    reports.add(output / "junit.xml", parts_junit(merged));
    reports.add(output / "index.html", parts_html(merged));
    reports.add(output / record_file, parts_json(merged));
    reports.write();
    return merged;
}

} // namespace keiko
