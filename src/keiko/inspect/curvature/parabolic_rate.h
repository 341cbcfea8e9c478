#pragma once

#include "keiko/geometry/bezier/bezier.h"

namespace keiko {

/// Rate, in 1/mm a mm, at which the principal curvature that is 0 changes across a parabolic curve
/// at a place of it; 0 if the place is singular or planar. Needs derivatives to order 3.
double parabolic_rate(const SurfaceDerivatives& s);

} // namespace keiko
