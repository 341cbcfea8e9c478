#pragma once

#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/camera.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace keiko {

/// Numbers of a picture's pixels.
struct PictureSize {
    int width, height; ///< from 1
};
/// The key `size` of a table, if it has one. Throws Error.
std::optional<PictureSize> picture_size_from(const TomlTable& table);

/// The camera by the keys projection, eye, target, up, vertical_fov and orthographic_height, see
/// docs/scene-format.md; its picture's size is left as it is. Throws Error.
Camera camera_of(const TomlTable& table);

/// The camera of a whole [camera] table, with `size`, if it has one. Throws Error.
Camera camera_from(const TomlTable& table);

/// Whether a view's name is that of a file: it ends in .toml.
bool is_view_file(std::string_view name);

/// Reads a view (keiko-view/1, docs/scene-format.md); the picture's size is left as it is. Throws
/// Error with file, line and column.
Camera read_view(const std::filesystem::path& path);

} // namespace keiko
