#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <optional>

namespace keiko {

/// unit_normal, but where one tangent is all but gone (within 1e-8 of the way to a pole) it is
/// taken as gone: what is left of it is rounding, and the pole's own normal is closer.
std::optional<Vec3> robust_normal(SurfaceDerivatives s, const Vec2& uv);

} // namespace keiko
