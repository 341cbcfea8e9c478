#pragma once

#include "keiko/inspect/basics/placed_face.h"

namespace keiko {

/// Area of the material of a placed face to some ten per cent, mm2: by the material's stretches on
/// 8 lines of each patch.
double rough_area(const SurfaceModel& model, const PlacedFace& of);

} // namespace keiko
