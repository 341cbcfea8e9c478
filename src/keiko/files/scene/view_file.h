#pragma once

#include "keiko/scene/camera.h"

#include <filesystem>
#include <string_view>

namespace keiko {

/// Whether a view's name is that of a file: it ends in .toml.
bool is_view_file(std::string_view name);

/// Reads a view (keiko-view/1, docs/scene-format.md); the picture's size is left as it is. Throws
/// Error with file, line and column.
Camera read_view(const std::filesystem::path& path);

} // namespace keiko
