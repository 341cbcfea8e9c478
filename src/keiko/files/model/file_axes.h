#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <string_view>

namespace keiko {

/// Turns a model into the vehicle frame: `axes` names the axes of its file that point rearwards,
/// to the right and up, with a minus where it is their other end, as "x,-z,y" of a file whose y is
/// up and whose z is to the left. Only placements change, by exact numbers. Throws Error for other
/// words, an axis named twice, and axes that would mirror the body.
void turn_axes(SurfaceModel& model, std::string_view axes);

} // namespace keiko
