#pragma once

#include "keiko/files/toml/toml_reader.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// The camera by the keys projection, eye, target, up, vertical_fov and orthographic_height, see
/// docs/scene-format.md; its picture's size is left as it is. Throws Error.
Camera camera_of(const TomlTable& table);

} // namespace keiko
