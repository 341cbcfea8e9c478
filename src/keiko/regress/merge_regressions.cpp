#include "keiko/base/error.h"
#include "keiko/base/field_error.h"
#include "keiko/regress/suite_files.h"

#include <map>

namespace keiko {
namespace fs = std::filesystem;
namespace {

/// What of a shard the others must agree with.
void require_same_suite(const Regression& one, const Regression& first, const fs::path& folder) {
    const auto fail = [&](const char* what) {
        throw Error(folder.string(), "", std::string("is a shard of another run: ") + what);
    };
    if (one.suite != first.suite) fail("its suite has other fixtures");
    if (one.shards != first.shards) fail("it is divided in another number of shards");
    if (one.suite_key != first.suite_key)
        fail("files, baselines or the program were others when it ran");
    if (one.tool_version != first.tool_version) fail("it is of another version of Keiko");
}

/// The shards by number. Throws Error where they are not all of one run, each once.
std::map<int, Regression> read_shards(std::span<const fs::path> folders) {
    std::map<int, Regression> shards;
    std::map<int, fs::path> places;
    for (const fs::path& folder : folders) {
        Regression shard = read_reports(folder);
        const int number = shard.shard;
        if (!shards.empty()) require_same_suite(shard, shards.begin()->second, folder);
        if (const auto [at, added] = places.emplace(number, folder); !added)
            throw Error(folder.string(), "",
                        "is shard " + std::to_string(number) + ", as is " + at->second.string());
        shards.emplace(number, std::move(shard));
    }
    return shards;
}

void require_every_shard(const std::map<int, Regression>& shards) {
    const int count = shards.begin()->second.shards;
    for (int number = 1; number <= count; ++number)
        if (!shards.contains(number))
            throw Error(
                "", "",
                "shard " + std::to_string(number) + " of " + std::to_string(count) + " is missing");
}

/// The run that was divided.
Regression joined(std::map<int, Regression> shards) {
    std::map<std::string, FixtureOutcome> outcomes;
    for (auto& [number, shard] : shards)
        for (FixtureOutcome& fixture : shard.fixtures)
            outcomes.emplace(fixture.name, std::move(fixture));
    Regression merged = std::move(shards.begin()->second);
    merged.shard = merged.shards = 1;
    merged.fixtures.clear();
    for (auto& [name, outcome] : outcomes) merged.fixtures.push_back(std::move(outcome));
    return merged;
}

} // namespace

Regression merge_regressions(std::span<const fs::path> folders, const fs::path& output) {
    for (const fs::path& folder : folders)
        if (fs::exists(output) && fs::equivalent(folder, output))
            throw FieldError("output", output.string() + " is a shard itself");
    withdraw_reports(output);
    std::map<int, Regression> shards = read_shards(folders);
    require_every_shard(shards);
    const Regression merged = joined(std::move(shards));
    const FolderLock lock(output);
    write_reports(output, merged);
    return merged;
}

} // namespace keiko
