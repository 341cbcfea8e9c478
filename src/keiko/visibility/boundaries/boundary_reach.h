#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"

#include <cstdint>

namespace keiko {

/// mm: how far beside the borders of a placed face, or the creases inside it, a ray may still meet
/// the face for the tracer's room for rounding.
double boundary_reach(const SurfaceModel& model, std::uint32_t instance, std::uint32_t face);

/// The same beside one trim curve, whose seam may be wider.
double boundary_reach(const SurfaceModel& model, const Tracer& tracer, std::uint32_t instance,
                      std::uint32_t face, std::uint32_t trim_curve);

} // namespace keiko
