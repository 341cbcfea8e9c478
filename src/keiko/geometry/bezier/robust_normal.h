#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <optional>

namespace keiko {

/// unit_normal that treats a nearly vanishing tangent (within 1e-8 of the distance to a pole) as 0.
/// The rest of such a tangent is rounding, and the pole's own normal is closer.
std::optional<Vec3> robust_normal(SurfaceDerivatives s, const Vec2& uv);

} // namespace keiko
