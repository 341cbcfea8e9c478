#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <string>

namespace keiko {

/// Name of a placed face: "face 12 (fender-outer)". If the model has several instances, it is "face
/// 12 of nut", or "face 12 of nut, instance 3" if several instances have that name.
std::string placed_face_name(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

} // namespace keiko
