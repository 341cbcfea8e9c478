#pragma once

#include "keiko/inspect/basics/placed_face.h"

namespace keiko {

/// Area of the material of a placed face to a few per cent, mm2: by the middles of 8 x 8 cells of
/// each patch.
double rough_area(const SurfaceModel& model, const PlacedFace& of);

} // namespace keiko
