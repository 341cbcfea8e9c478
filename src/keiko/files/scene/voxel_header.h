#pragma once

#include "keiko/scene/volume_spec.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

/// The voxels that a text in keiko-voxels/1 describes; `source` is the file name for messages and
/// the one that other files are relative to. Throws Error with file, line and column.
VoxelFiles parse_voxel_header(std::string_view text, const std::string& source);

/// The voxels that a file in keiko-voxels/1 describes. Throws Error.
VoxelFiles read_voxel_header(const std::filesystem::path& path);

} // namespace keiko
