#include "keiko/base/error.h"
#include "keiko/batch/joined_run.h"
#include "keiko/regress/regress.h"
#include "keiko/regress/suite_files.h"

#include <system_error>

namespace keiko {
namespace fs = std::filesystem;
namespace {

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

} // namespace

Regression merge_regressions(std::span<const fs::path> named, const fs::path& output) {
    const ShardFolders found = shard_folders(named, regression_file);
    require_apart(found.folders, output);
    withdraw_reports(output, regression_file);
    constexpr RunMembers<Regression, FixtureOutcome> members{
        &Regression::suite_key, &Regression::suite, &Regression::fixtures};
    const Regression merged = joined_run(found, members, read_reports);
    const FolderLock lock(output);
    write_reports(output, merged);
    return merged;
}

} // namespace keiko
