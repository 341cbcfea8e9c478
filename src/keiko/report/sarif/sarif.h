#pragma once

#include "keiko/inspect/inspection.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace keiko {

/// Number of results that GitHub accepts in one run; it refuses a file with more.
constexpr std::size_t most_sarif_results = 25'000;

/// The findings as a SARIF 2.1.0 log [SARIF], for tools that show those of static analysers: one
/// rule a criterion, one result a finding. A failure is an error; what cannot be distinguished from
/// its limit is a warning, `properties.verdict` undecided; a lost face is an error of the run.
///
/// `files` are those of the model in the order of FaceFacts::file. A result stands in the file of
/// its first face, on the line of the face's entity or else on line 1, and names the second face as
/// a related location. Its partial fingerprint is a hash of the code and the names of the faces.
/// Of more than most_sarif_results findings the worst are kept, and a notification states how many
/// were left out. The log holds no time, so that every run gives the same bytes.
std::string sarif_json(const Inspection& inspection, const std::string& tool_version,
                       std::span<const std::filesystem::path> files);

} // namespace keiko
