#pragma once

#include "keiko/tubes/tube_view.h"

namespace keiko {

/// Projected solid angle in sr of a part of the lateral surface of a tube, clipped by the tangent
/// plane: eq. (2.5) of physics 2.4, the inner integral in closed form and the outer by Gauss
/// between the angles at which the horizon passes over a rim, a cut or the axis direction.
double cylinder_solid_angle(const TubeView& view, const VisiblePart& part);

} // namespace keiko
