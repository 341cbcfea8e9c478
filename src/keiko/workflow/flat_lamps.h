#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/areas/area_lights.h"

#include <vector>

namespace keiko {

/// True if the control points of each face lie in a plane.
bool is_flat(const SurfaceModel& model);

/// True if no panel hides the bright side of another: each has all others behind it, or in its
/// plane if it shines both ways.
bool hide_nothing(const std::vector<PolygonLight>& panels);

} // namespace keiko
