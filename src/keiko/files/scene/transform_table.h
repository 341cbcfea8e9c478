#pragma once

#include "keiko/scene/scene_spec.h"

namespace keiko {

class TomlTable;

/// The placement that a table `transform` states. Throws Error with file, line and column.
ModelTransform transform_from(const TomlTable& table);

} // namespace keiko
