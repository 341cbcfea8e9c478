#pragma once

#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/criteria_preset.h"

namespace keiko {

// The tables of limits that presets and their zones have. Each throws Error with file, line and
// column for a limit that makes no sense.

/// Range of lengths in mm: beyond it no limit of a surface makes sense; a mistyped unit does.
constexpr TomlLimits limit_lengths{.low = 0, .high = 1e6, .above_low = true};
/// Range of angles, degrees.
constexpr TomlLimits limit_angles{.low = 0, .high = 180, .above_low = true};

/// Reads the limits of [seam], gap to fading, into a preset; other keys are left for the caller.
void read_seam_limits(const TomlTable& table, CriteriaPreset& preset);
/// The limits of [lines].
LineLimits line_limits_from(const TomlTable& table);
/// The limits of [surface].
SurfaceLimits surface_limits_from(const TomlTable& table);
/// The limits of [structure].
StructureLimits structure_limits_from(const TomlTable& table);
/// The limits of [look].
LookLimits look_limits_from(const TomlTable& table);

} // namespace keiko
