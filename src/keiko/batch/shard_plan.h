#pragma once

#include "keiko/base/export.h"
#include "keiko/batch/shard.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

/// Part of a run: a fixture or a body.
struct PlannedPart {
    std::string name; ///< unique in its run
    std::string key;  ///< SHA-256 of everything that its result depends on
    int shard = 1;    ///< that runs it
};

/// Division of a run into shards: every one of them makes the same.
struct ShardPlan {
    std::string command;            ///< "regress", "check" or "inspect"
    std::string tool_version;       ///< version of Keiko
    std::string program;            ///< build of Keiko and instruction set
    std::string key;                ///< SHA-256 of everything that the run depends on
    int shards = 1;                 ///< number of shards
    std::vector<PlannedPart> parts; ///< in the order of the run
};

/// Plan of this program for parts, whose shards are not set yet, by their costs.
ShardPlan balanced_plan(std::string command, std::string key, std::vector<PlannedPart> parts,
                        std::span<const double> costs, int shards);

/// Indices of the parts of a shard.
std::vector<std::size_t> share_of(const ShardPlan& plan, int shard);

/// The plan as "keiko-shards/1".
std::string plan_json(const ShardPlan& plan);
/// Inverse of plan_json; `file` is for messages. Throws Error.
ShardPlan parse_plan(const std::string& json, const std::string& file);

/// Plan of the run to which a folder belongs; nullopt where there is none. Throws Error.
std::optional<ShardPlan> kept_plan(const std::filesystem::path& output);

/// Makes a folder that of a run, by a file with its plan, and in it the folder of a shard. Throws
/// Error where it is that of another run, naming the difference.
void claim_shard(const std::filesystem::path& output, const ShardPlan& plan, int number);

/// Throws Error unless a folder is still that of this run.
void require_claimed(const std::filesystem::path& output, const ShardPlan& plan);

} // namespace keiko
