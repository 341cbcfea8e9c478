#pragma once

#include "keiko/patch/surface_model.h"

#include <string>

namespace keiko {

/// "face 12 (fender-outer)", with its instance where the model has several.
std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

} // namespace keiko
