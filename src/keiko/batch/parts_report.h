#pragma once

#include "keiko/base/export.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Result of a part, from good to bad.
enum class PartState {
    pass,      ///< within all limits
    undecided, ///< deserves a look
    fail,      ///< beyond a limit
    error      ///< could not be judged
};

/// All states, from good to bad.
inline constexpr std::array every_part_state{PartState::pass, PartState::undecided, PartState::fail,
                                             PartState::error};
/// "pass", "undecided", "fail", "error"
std::string_view name_of(PartState state);

/// Outcome of a body that was judged by itself.
struct PartOutcome {
    std::string name;                  ///< unique in its run; that of its folder
    std::string file;                  ///< as the user named it
    PartState state = PartState::pass; ///< its verdict
    std::string summary{};             ///< one line: counts, or the reason of an error
    std::string page{};                ///< file to open first, in its folder; empty of an error
};

/// One run over bodies that are judged one by one, or a shard of it.
struct PartsRun {
    std::string command;              ///< "check" or "inspect"
    std::string tool_version;         ///< version of Keiko
    std::string key;                  ///< SHA-256 of everything that the run depends on
    int shard = 1, shards = 1;        ///< number of the shard, and of all shards
    std::vector<std::string> all{};   ///< every part of the run, by name
    std::vector<PartOutcome> parts{}; ///< those of the shard, in the order of the run

    /// Number of parts in a state.
    std::size_t count(PartState state) const;
    /// The worst state of all parts.
    PartState state() const;
};

/// "7 parts, 5 pass, 0 undecided, 1 fail, 1 error"
std::string summary_of(const PartsRun& run);

/// An outcome with its key, the file that marks a finished part.
std::string part_json(const PartOutcome& outcome, const std::string& key);
/// Outcome in the text of part_json; one without a name if its key is another. Throws Error.
PartOutcome parse_part(const std::string& json, const std::string& key, const std::string& file);

/// The run as "keiko-parts/1". It holds no times: every run gives the same bytes.
std::string parts_json(const PartsRun& run);
/// Inverse of parts_json; `file` is for messages. Throws Error.
PartsRun parse_parts(const std::string& json, const std::string& file);

/// Folder of a part's results, relative to that of the run.
std::string part_folder(const std::string& name);

/// The run as a page with a row a part that leads to the part's own.
std::string parts_html(const PartsRun& run);

/// The run for build servers: a case a part.
std::string parts_junit(const PartsRun& run);

} // namespace keiko
