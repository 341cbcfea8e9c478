#pragma once

#include "keiko/light/spotlight/spotlight.h"

#include <string>

namespace keiko {

class TomlTable;

/// Reads how the intensity of a [[spotlight]] goes with direction into it: edge, q, exponent,
/// coefficients, table or file, half_angle, half_angle_across, pattern. Throws Error with file,
/// line and column.
void take_beam(const TomlTable& table, Spotlight& light);

/// Lines that read back as the same.
std::string beam_text(const Spotlight& light);

} // namespace keiko
