#pragma once

#include "keiko/base/export.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/report/content/report.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// "0.1.0"
std::string version();

/// Build of Keiko, by its build id, and the instruction set that it uses on this processor: what
/// the last bits of results depend on.
std::string program();

/// The time of the clock in UTC, up to 31 characters; `format` is that of strftime.
std::string utc_now(const char* format);

/// Input files and all that TOML files among them name, each once, in the order of their paths.
std::vector<InputFile> input_files(std::span<const std::filesystem::path> inputs);

/// SHA-256 of everything that a run depends on: the build of Keiko, the processor's instruction
/// set, the program that imports models, `settings`, and the input files. Files named by TOML files
/// are among them. Each counts under its path from `folder`.
std::string input_key(std::span<const std::filesystem::path> inputs,
                      const std::filesystem::path& folder, const LoadOptions& load,
                      const std::string& settings = "");

} // namespace keiko
