#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <optional>

namespace keiko {

/// Unit normal along du x dv. Where a tangent vanishes (collapsed edge, pole) the limit from
/// inside the patch is taken by the second derivatives; nothing where that too is undefined.
/// `derivatives` must hold order 2.
std::optional<Vec3> unit_normal(const SurfaceDerivatives& derivatives, const Vec2& uv);

/// Principal curvatures in 1/mm with respect to the given unit normal, k1 >= k2; positive where
/// the surface bends towards the normal.
struct PrincipalCurvatures {
    double k1 = 0, k2 = 0;

    double mean() const { return (k1 + k2) / 2; }
    double gaussian() const { return k1 * k2; }
};

/// Needs derivatives of order 2 and a regular point (du x dv not 0).
PrincipalCurvatures principal_curvatures(const SurfaceDerivatives& derivatives, const Vec3& normal);

/// The same where rounding leaves three digits of them, or of the bend of a surface of the patch's
/// own size; nothing close to a pole, where the parameters run together, and at it.
std::optional<PrincipalCurvatures> reliable_curvatures(const SurfaceDerivatives& derivatives,
                                                       const Vec3& normal);

/// Curvature in 1/mm of the normal section along a tangent `direction` (need not be unit).
double normal_curvature(const SurfaceDerivatives& derivatives, const Vec3& normal,
                        const Vec3& direction);

} // namespace keiko
