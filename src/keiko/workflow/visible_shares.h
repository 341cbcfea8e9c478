#pragma once

#include "keiko/base/job.h"
#include "keiko/intersect/traversal/tracer.h"

#include <optional>
#include <vector>

namespace keiko {

/// Share of the area of each placed face, in the order of placed_faces(), that at least one of the
/// standing views shows. It is that of the places, spread evenly over its material, from which a
/// ray to an eye meets nothing. 0 for a face without material. `tracer`: of the model. `ground`: z
/// of the floor on which the viewers stand, mm; none: as of Framing. Throws Cancelled.
std::vector<double> visible_shares(const SurfaceModel& model, const Tracer& tracer,
                                   std::optional<double> ground, const Job& job);

} // namespace keiko
