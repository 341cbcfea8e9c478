#pragma once

#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// A level square at height `z` below, above or beside a body, its normal up. It is one bilinear
/// patch that extends a hundred times the body's size from the middle of its box, and at least 100
/// m. Lengths in mm.
SurfaceModel ground_plane(double z, const Box3& body);

} // namespace keiko
