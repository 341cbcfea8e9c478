#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <array>

namespace keiko {

/// Lengths of the sides of a patch's control polygons along u and along v, times the degree: no
/// less than the patch is long that way where it is not rational. mm.
std::array<double, 2> net_extents(const BezierPatchView& patch);

} // namespace keiko
