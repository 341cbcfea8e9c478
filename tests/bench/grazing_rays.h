#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"

#include "tests/bench/ray_set.h"

namespace keiko::bench {

/// Seeded rays through known points of the material, between 1e-4 and 1e-1 rad off its tangent
/// plane there (evenly by the logarithm), from outside of the body's box. The truth is left to
/// the caller.
RaySet grazing_rays(const SurfaceModel& model, const Box3& bounds, std::size_t count);

} // namespace keiko::bench
