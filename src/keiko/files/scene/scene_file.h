#pragma once

#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/scene_spec.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

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

/// Reads a scene file (keiko-scene/1, docs/scene-format.md) and the rig and materials files it
/// names. Paths in it are relative to the file itself. Throws Error with file, line and column.
SceneSpec read_scene(const std::filesystem::path& path);
/// Parses the text of a scene; `source` is the path that messages and relative paths refer to.
SceneSpec parse_scene(std::string_view text, const std::string& source);

} // namespace keiko
