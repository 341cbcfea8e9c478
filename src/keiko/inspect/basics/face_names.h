#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <string>

namespace keiko {

/// "face 12 (fender-outer)"; where the model has several instances, "face 12 of nut", and "face 12
/// of nut, instance 3" where several have that name.
std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

} // namespace keiko
