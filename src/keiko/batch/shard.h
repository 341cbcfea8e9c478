#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/batch/array_task.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace KEIKO_API keiko {

/// One of the shares into which a run is divided, each for a machine of its own.
struct Shard {
    int number = 1; ///< from 1 to count
    int count = 1;  ///< of all shares; at most 100000
};

/// Shard that a text states: "K/N", or "auto": that of the array task in the environment, or
/// "auto/N": the one of N whose number the task has. Throws FieldError("shard").
Shard shard_of(const std::string& text, const Environment& environment);

/// Folder of a shard in the output folder of its run: "shard-3".
std::filesystem::path shard_folder(const std::filesystem::path& output, int number);

/// True for the name of a folder that shard_folder makes.
bool is_shard_name(const std::string& name);

/// Job whose stages state which part of how many they belong to: "2/7 hood: render".
Job job_of_part(const Job& job, std::size_t index, std::size_t count, const std::string& name);

} // namespace keiko
