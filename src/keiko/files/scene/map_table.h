#pragma once

#include "keiko/scene/material.h"

#include <vector>

namespace keiko {

class TomlTable;

/// Maps of a material by the tables `map` of its own table. Throws Error with file, line and
/// column, also for a map of what the material does not have.
std::vector<MaterialMap> maps_from(const TomlTable& table, const Material& material);
/// Maps of the luminance of a lamp by the tables `map` of its own table. Throws Error with file,
/// line and column.
std::vector<MaterialMap> luminance_maps_from(const TomlTable& table);

} // namespace keiko
