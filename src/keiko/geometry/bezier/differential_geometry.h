#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <optional>

namespace keiko {

/// Unit normal along du x dv. Where a tangent vanishes (collapsed edge, pole) the limit from inside
/// the patch is taken by the second derivatives; nullopt if that too is undefined. `derivatives`
/// must hold order 2.
std::optional<Vec3> unit_normal(const SurfaceDerivatives& derivatives, const Vec2& uv);

/// Principal curvatures in 1/mm with respect to the given unit normal, k1 >= k2; positive where
/// the surface bends towards the normal.
struct PrincipalCurvatures {
    double k1 = 0, k2 = 0;

    double mean() const { return (k1 + k2) / 2; }
    double gaussian() const { return k1 * k2; }
};

/// Principal curvatures at a regular point (du x dv not 0); needs derivatives of order 2.
PrincipalCurvatures principal_curvatures(const SurfaceDerivatives& derivatives, const Vec3& normal);

/// Principal curvatures with at least three digits beyond rounding, relative to them or to the
/// curvature of a surface of the patch's own size. nullopt at and close to a pole, where the
/// parameters coincide.
std::optional<PrincipalCurvatures> reliable_curvatures(const SurfaceDerivatives& derivatives,
                                                       const Vec3& normal);

/// Curvature in 1/mm of the normal section along a tangent `direction` (need not be unit).
double normal_curvature(const SurfaceDerivatives& derivatives, const Vec3& normal,
                        const Vec3& direction);

} // namespace keiko
