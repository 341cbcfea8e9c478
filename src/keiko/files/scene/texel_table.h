#pragma once

#include "keiko/scene/texel_spec.h"

namespace keiko {

class TomlTable;

/// Texels by the table `texels` of a material. Throws Error with file, line and column.
TexelSpec texels_from(const TomlTable& table);

} // namespace keiko
