#pragma once

#include "keiko/report/markup/json_text.h"
#include "keiko/scene/camera.h"

namespace keiko {

Json camera_json(const Camera& camera);
/// Inverse of camera_json. Throws Json::exception.
Camera camera_from(const Json& json);

} // namespace keiko
