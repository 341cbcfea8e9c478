#pragma once

#include "keiko/inspect/inspection.h"

#include <filesystem>
#include <span>
#include <string>

namespace keiko {

/// The findings as a SARIF 2.1.0 log (OASIS standard), for tools that show those of static
/// analysers: one rule a criterion, one result a finding. A failure is an error; what cannot be
/// told from its limit is a warning, `properties.verdict` undecided; a lost face is an error of the
/// run. A result names its seam and faces, and the model file where `files` is only one. It holds
/// no time, so that every run gives the same bytes.
std::string sarif_json(const Inspection& inspection, const std::string& tool_version,
                       std::span<const std::filesystem::path> files);

} // namespace keiko
