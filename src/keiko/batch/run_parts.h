#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/batch/parts_report.h"
#include "keiko/batch/shard.h"
#include "keiko/import/worker/load_model.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Options of run_parts.
struct PartsOptions {
    std::string command;                         ///< "check" or "inspect"
    std::vector<std::filesystem::path> models{}; ///< a body each
    std::filesystem::path output;                ///< folder of the run, which all shards share
    Shard shard;                                 ///< the share that is run
    std::string settings{}; ///< all else on which results depend, except the content of files
    std::vector<std::filesystem::path> files{}; ///< whose content results depend on, besides
    LoadOptions load{};                         ///< of the models
};

/// Result of one body.
struct PartResult {
    PartState state = PartState::pass; ///< its verdict
    std::string summary;               ///< one line
    std::string page;                  ///< the one of `files` to open first
    FolderContent files;               ///< results, for a folder
};

/// Judges one body, whose results will lie in a folder. Throws Error, Cancelled.
using JudgePart = std::function<PartResult(const std::filesystem::path& model,
                                           const std::filesystem::path& folder, const Job& job)>;

/// Judges the bodies of a shard one by one. Writes parts/NAME/results of each once it is done, and
/// at the end shard-K/parts.json; each whole or not at all. Results that are there are taken if all
/// they were made from is the same, this program included. A body that cannot be judged is reported
/// in its outcome. Throws Error where the output folder is that of another run; Cancelled.
PartsRun run_parts(const PartsOptions& options, const JudgePart& judge, const Job& job = {});

/// True if a folder is the output folder of run_parts. Throws Error for a damaged plan.
bool holds_parts(const std::filesystem::path& output);

/// Joins the shards of a run in its output folder, as if it had not been divided: writes
/// parts.json, junit.xml and index.html there. Throws Error where a shard is missing or of another
/// run.
PartsRun merge_parts(const std::filesystem::path& output);

} // namespace keiko
