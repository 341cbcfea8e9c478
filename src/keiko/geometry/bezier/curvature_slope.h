#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

namespace keiko {

/// How fast the curvature of the normal section along a tangent `direction` changes along it, in
/// 1/mm2: the derivative of its curvature by arc length, which is the covariant derivative of the
/// second fundamental form (do Carmo, Differential Geometry, 3-3), with respect to the given unit
/// normal. Needs derivatives of order 3 and a regular point; `direction` need not be unit.
double normal_curvature_slope(const SurfaceDerivatives& derivatives, const Vec3& normal,
                              const Vec3& direction);

} // namespace keiko
