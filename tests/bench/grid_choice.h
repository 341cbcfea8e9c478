#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"

#include "tests/bench/contender.h"

#include <memory>

namespace keiko::bench {

/// Embree triangles from the coarsest per-span grid whose zebra error on the primary rays is at
/// most 0.1 px at p99.9. Where refining stops to help or `most_triangles` is reached, it is the
/// finest grid that was tried, with a remark.
std::unique_ptr<Contender> fitted_grid(const SurfaceModel& model, const Box3& bounds,
                                       const RaySet& primary, std::size_t most_triangles);

} // namespace keiko::bench
