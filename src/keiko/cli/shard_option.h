#pragma once

#include "keiko/api/check.h"
#include "keiko/api/regress.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace keiko::cli {

/// The share of a run that a command takes.
class ShardOption {
public:
    /// Adds --shard to a command, to which none of the `others` can be added then.
    CLI::Option* add_to(CLI::App& command, const std::string& text,
                        std::initializer_list<const char*> others = {});

    /// True if it was given.
    bool requested() const { return !text_.empty(); }
    /// The shard, of the array task in the environment if that is requested. Throws FieldError.
    Shard shard() const;
    /// The job with the threads of the array task, if the shard is that of one and no number of
    /// threads was given.
    Job job(const Job& job) const;

private:
    std::string text_;
};

/// Help of --shard for commands that judge models.
constexpr const char* shard_of_models =
    "each MODEL is a body of its own; K/N: judge the K-th of N shares of about the same cost; "
    "auto, "
    "auto/N: the share of this task of an array job; see merge";

/// Options of a run over the models of a command, one body each. Every option that was given
/// counts among the settings, unless results do not depend on it.
PartsOptions parts_options(const CLI::App& command, const ShardOption& shard,
                           std::span<const std::filesystem::path> models,
                           const std::filesystem::path& output);

/// Prints a line a part, and one of them all that names where to look. Returns the exit code.
int tell_parts(const PartsRun& run, const std::filesystem::path& place);

/// Result that a verdict is, of a part.
PartState part_state(Verdict verdict);

} // namespace keiko::cli
