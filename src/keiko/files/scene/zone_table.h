#pragma once

#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/criteria_preset.h"

#include <functional>
#include <vector>

namespace keiko {

/// The limits of the preset that the key `preset` of a zone's table names.
using PresetOfZone = std::function<CriteriaPreset(const TomlTable& zone)>;

/// The zones of the [[zone]] tables of a preset or a fixture (docs/file-formats.md). Limits that a
/// zone does not have are those of `preset`. Throws Error with file, line and column.
std::vector<Zone> zones_from(const TomlTable& root, const CriteriaPreset& preset,
                             const PresetOfZone& named);
/// zones_from() with the standard presets and preset files.
std::vector<Zone> zones_from(const TomlTable& root, const CriteriaPreset& preset);

} // namespace keiko
