#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <array>

namespace keiko {

/// Lengths of the sides of a patch's control polygons along u and along v, times the degree, mm.
/// Each is at least the patch's length in that direction, if the patch is not rational.
std::array<double, 2> net_extents(const BezierPatchView& patch);

} // namespace keiko
