#pragma once

#include "keiko/scene/environment_spec.h"

namespace keiko {

class TomlTable;

/// The surroundings that a table `[environment]` describes. Throws Error with file, line and
/// column.
EnvironmentSpec environment_from(const TomlTable& table);

} // namespace keiko
