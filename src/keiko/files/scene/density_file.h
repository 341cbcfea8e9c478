#pragma once

#include "keiko/light/fog/voxel_density.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

/// Reads a grid of densities (keiko-density/1, docs/scene-format.md). Throws Error with file and
/// reason.
VoxelDensity read_density(const std::filesystem::path& path);
/// Parses the text of a grid of densities; `source` is the file name for messages.
VoxelDensity parse_density(std::string_view text, const std::string& source);

} // namespace keiko
