#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

namespace keiko {

/// Derivative of the curvature of the normal section along a tangent `direction` by arc length
/// along it, 1/mm2, with respect to the given unit normal. It is the covariant derivative of the
/// second fundamental form (do Carmo, Differential Geometry, 3-3). Needs derivatives of order 3 and
/// a regular point; `direction` need not be unit.
double normal_curvature_slope(const SurfaceDerivatives& derivatives, const Vec3& normal,
                              const Vec3& direction);

} // namespace keiko
