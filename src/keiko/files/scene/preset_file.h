#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/criteria_preset.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace KEIKO_API keiko {

/// Reads a criteria preset (keiko-preset/1, docs/file-formats.md). Throws Error with file, line
/// and column.
CriteriaPreset read_preset(const std::filesystem::path& path);
/// Parses the text of a criteria preset; `source` is the file name for messages.
CriteriaPreset parse_preset(std::string_view text, const std::string& source);

/// The presets of lightrigs/presets as they were when the program was built. The first is the
/// default.
std::span<const CriteriaPreset> standard_presets();
/// Standard preset of a name; throws Error listing the known ones.
const CriteriaPreset& preset_by_name(std::string_view name);

/// True for a text that is the path of a preset file, no standard preset's name: it ends in .toml
/// or holds a folder.
bool is_preset_path(const std::string& name_or_file);
/// Preset of a file where the text ends in .toml or holds a folder, else the standard preset of
/// that name.
CriteriaPreset preset_by_name_or_file(const std::string& name_or_file);

} // namespace keiko
