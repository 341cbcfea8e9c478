#pragma once

#include "keiko/files/scene/camera_table.h"
#include "keiko/scene/scene_spec.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace keiko {

/// Reads a scene file (keiko-scene/1, docs/scene-format.md) and the rig and materials files it
/// names. Paths in it are relative to the file itself. Throws Error with file, line and column.
SceneSpec read_scene(const std::filesystem::path& path);
/// Parses the text of a scene; `source` is the path that messages and relative paths refer to.
SceneSpec parse_scene(std::string_view text, const std::string& source);

} // namespace keiko
