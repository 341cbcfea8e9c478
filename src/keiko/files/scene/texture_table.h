#pragma once

#include "keiko/scene/material_map.h"

namespace keiko {

class TomlTable;

/// True for textures of two coordinates, which fill no space.
bool is_two_dimensional(TextureKind kind);

/// The `texture` of a map that drives a quantity, see docs/scene-format.md. Throws Error with file,
/// line and column.
TextureSpec texture_from(const TomlTable& table, MappedQuantity drives);

} // namespace keiko
