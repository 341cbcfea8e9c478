#pragma once

#include "keiko/batch/shard_plan.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// Folders in which the shards of a run left their records.
struct ShardFolders {
    std::vector<std::filesystem::path> folders; ///< by number, or as they were named
    std::optional<ShardPlan> plan;              ///< of the run, where its folder was named
};

/// Shards that a user names: output folders of runs, each with its shards, or shards by themselves.
/// In the former only folders that have a `record` file count, for others are not done. Throws
/// Error.
ShardFolders shard_folders(std::span<const std::filesystem::path> named, const std::string& record);

/// Facts on its run that the record of a shard states.
struct ShardRecord {
    std::filesystem::path folder;   ///< where the record lies
    Shard shard;                    ///< its own number, and that of all
    std::string tool_version;       ///< version of Keiko
    std::string key;                ///< SHA-256 of everything that the run depends on
    std::vector<std::string> parts; ///< all parts of the run, by name
    std::vector<std::string> done;  ///< the parts of the shard, by name
};

/// Throws Error unless the records are all shards of one run, each once, and have every part of it:
/// naming the folder that is of another run, or the shards that are missing.
void require_whole_run(std::span<const ShardRecord> records, const std::optional<ShardPlan>& plan);

/// Removes the reports of an earlier run from an output folder, its `record` file among them: they
/// must not pass for this one's, whatever becomes of it. Throws Error while another process writes
/// to the folder.
void withdraw_reports(const std::filesystem::path& output, const std::string& record);

} // namespace keiko
