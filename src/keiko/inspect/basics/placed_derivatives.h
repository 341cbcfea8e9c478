#pragma once

#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// Derivatives to order 3 by the patch parameters of a patch placed by an instance; world, mm.
SurfaceDerivatives placed_derivatives(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t patch, const Vec2& uv);

} // namespace keiko
