#pragma once

#include "keiko/scene/volume_spec.h"

namespace keiko {

class TomlTable;

/// The volume of a [[volume]], with the header of its voxels read. Throws Error with file, line and
/// column.
VolumeSpec volume_from(const TomlTable& table);

} // namespace keiko
