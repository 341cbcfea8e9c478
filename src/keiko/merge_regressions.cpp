#include "keiko/suite_files.h"

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

} // namespace

Regression merge_regressions(std::span<const fs::path> folders, const fs::path& output) {
    for (const fs::path& folder : folders)
        if (fs::exists(output) && fs::equivalent(folder, output))
            throw Error(output.string(), "--output", "is a shard itself");
    std::map<std::string, FixtureOutcome> outcomes;
    std::map<int, fs::path> numbers;
    Regression merged;
    for (const fs::path& folder : folders) {
        Regression shard = read_reports(folder);
        if (numbers.empty()) merged = shard;
        require_same_suite(shard, merged, folder);
        if (const auto [at, added] = numbers.emplace(shard.shard, folder); !added)
            throw Error(
                folder.string(), "",
                "is shard " + std::to_string(shard.shard) + ", as is " + at->second.string());
        for (FixtureOutcome& fixture : shard.fixtures)
            outcomes.emplace(fixture.name, std::move(fixture));
    }
    for (int number = 1; number <= merged.shards; ++number)
        if (!numbers.contains(number))
            throw Error("", "",
                        "shard " + std::to_string(number) + " of " + std::to_string(merged.shards) +
                            " is missing");
    merged.shard = merged.shards = 1;
    merged.fixtures.clear();
    for (auto& [name, outcome] : outcomes) merged.fixtures.push_back(std::move(outcome));
    const FolderLock lock(output);
    remove_reports(output);
    write_reports(output, merged);
    return merged;
}

} // namespace keiko
