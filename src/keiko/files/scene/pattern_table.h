#pragma once

#include "keiko/light/spotlight/spotlight.h"

#include <string>

namespace keiko {

class TomlTable;

/// Reads the table `pattern` of a [[spotlight]] into it. Throws Error with file, line and column.
void take_pattern(const TomlTable& pattern, Spotlight& light);

/// The line that reads back as the same; nothing for a plain beam.
std::string pattern_text(const Spotlight& light);

} // namespace keiko
