#pragma once

#include "keiko/scene/criteria_preset.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace keiko {

/// Reads a criteria preset (keiko-preset/1, docs/file-formats.md). Throws Error with file, line
/// and column.
CriteriaPreset read_preset(const std::filesystem::path& path);
/// The same from a text; `source` is the file name for messages.
CriteriaPreset parse_preset(std::string_view text, const std::string& source);

/// The presets of lightrigs/presets as they were when the program was built. The first is the
/// default.
std::span<const CriteriaPreset> standard_presets();
/// The one of that name; throws Error listing those there are.
const CriteriaPreset& preset_by_name(std::string_view name);

/// What a user asks for: a file where the text ends in .toml or holds a folder, or else a name.
CriteriaPreset preset_by_name_or_file(const std::string& name_or_file);

} // namespace keiko
