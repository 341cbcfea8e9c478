#include "keiko/base/error.h"
#include "keiko/batch/whole_run.h"
#include "keiko/regress/regress.h"
#include "keiko/regress/suite_files.h"

#include <map>
#include <system_error>

namespace keiko {
namespace fs = std::filesystem;
namespace {

ShardRecord record_of(const Regression& shard, const fs::path& folder) {
    ShardRecord record{
        folder, {shard.shard, shard.shards}, shard.tool_version, shard.suite_key, shard.suite, {}};
    for (const FixtureOutcome& fixture : shard.fixtures) record.done.push_back(fixture.name);
    return record;
}

/// Throws Error where a shard lies in the folder of the reports, which would take its place.
void require_apart(std::span<const fs::path> shards, const fs::path& output) {
    for (const fs::path& shard : shards) {
        std::error_code ignored; // a folder that is not there is no other's
        if (!fs::equivalent(shard, output, ignored)) continue;
        if (!fs::exists(shard / regression_file))
            throw Error(shard.string(), "", "holds no shard that is done");
        throw FieldError("output", output.string() + " is a shard itself");
    }
}

/// The run that was divided.
Regression joined(std::vector<Regression> shards) {
    std::map<std::string, FixtureOutcome> outcomes;
    for (Regression& shard : shards)
        for (FixtureOutcome& fixture : shard.fixtures)
            outcomes.emplace(fixture.name, std::move(fixture));
    Regression merged = std::move(shards.front());
    merged.shard = merged.shards = 1;
    merged.fixtures.clear();
    for (auto& [name, outcome] : outcomes) merged.fixtures.push_back(std::move(outcome));
    return merged;
}

} // namespace

Regression merge_regressions(std::span<const fs::path> named, const fs::path& output) {
    const ShardFolders found = shard_folders(named, regression_file);
    require_apart(found.folders, output);
    withdraw_reports(output);
    std::vector<Regression> shards;
    std::vector<ShardRecord> records;
    for (const fs::path& folder : found.folders) {
        shards.push_back(read_reports(folder));
        records.push_back(record_of(shards.back(), folder));
    }
    require_whole_run(records, found.plan);
    const Regression merged = joined(std::move(shards));
    const FolderLock lock(output);
    write_reports(output, merged);
    return merged;
}

} // namespace keiko
