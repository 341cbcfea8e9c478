#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"

#include <optional>

namespace KEIKO_API keiko {

/// Unit normal along du x dv. Where a tangent vanishes (collapsed edge, pole) the limit from inside
/// the patch is taken by the second derivatives; nullopt if that too is undefined. `derivatives`
/// must hold order 2.
std::optional<Vec3> unit_normal(const SurfaceDerivatives& derivatives, const Vec2& uv);

/// Principal curvatures in 1/mm with respect to the given unit normal, k1 >= k2; positive where
/// the surface bends towards the normal.
struct PrincipalCurvatures {
    double k1 = 0, k2 = 0; ///< principal curvatures, 1/mm

    /// Mean curvature, 1/mm.
    double mean() const { return (k1 + k2) / 2; }
    /// Gaussian curvature, 1/mm2.
    double gaussian() const { return k1 * k2; }
};

/// Principal curvatures at a regular point (du x dv not 0); needs derivatives of order 2.
PrincipalCurvatures principal_curvatures(const SurfaceDerivatives& derivatives, const Vec3& normal);

/// True if curvatures have at least three digits beyond rounding, relative to them or to the
/// curvature of a surface of the patch's own size. False at and close to a pole, where the
/// parameters coincide.
bool has_reliable_curvatures(const SurfaceDerivatives& derivatives, const Vec3& normal);

/// Principal curvatures; nullopt where they are not reliable.
std::optional<PrincipalCurvatures> reliable_curvatures(const SurfaceDerivatives& derivatives,
                                                       const Vec3& normal);

/// Second fundamental form by an orthonormal frame of the tangent plane, 1/mm.
struct SecondForm {
    double xx = 0; ///< curvature of the normal section along x
    double xy = 0; ///< twist
    double yy = 0; ///< curvature of the normal section along y
};

/// Second fundamental form with respect to the given unit normal. The frame's x is along a tangent
/// `direction` (need not be unit), its y along normal x `direction`. Needs derivatives of order 2
/// and a regular point.
SecondForm second_form(const SurfaceDerivatives& derivatives, const Vec3& normal,
                       const Vec3& direction);

/// Curvature in 1/mm of the normal section along a tangent `direction` (need not be unit).
double normal_curvature(const SurfaceDerivatives& derivatives, const Vec3& normal,
                        const Vec3& direction);

/// Derivative of the curvature of the normal section along a tangent `direction` by arc length
/// along it, 1/mm2, with respect to the given unit normal. It is the covariant derivative of the
/// second fundamental form (do Carmo, Differential Geometry, 3-3). Needs derivatives of order 3 and
/// a regular point; `direction` need not be unit.
double normal_curvature_slope(const SurfaceDerivatives& derivatives, const Vec3& normal,
                              const Vec3& direction);

/// unit_normal that treats a nearly vanishing tangent (within 1e-8 of the distance to a pole) as 0.
/// The rest of such a tangent is rounding, and the pole's own normal is closer.
std::optional<Vec3> robust_normal(SurfaceDerivatives s, const Vec2& uv);

} // namespace keiko
