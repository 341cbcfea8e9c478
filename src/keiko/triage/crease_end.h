#pragma once

#include "keiko/inspect/inspection.h"

#include <optional>

namespace keiko {

/// The end, world, mm, of a smooth stretch that goes on at its other end from a crease of its line.
/// That the angle falls up to there is the design; what is left of it is the fault. nullopt for
/// other stretches.
std::optional<Vec3> end_of_crease(const Inspection& inspection, const MeasuredSeam& seam);

} // namespace keiko
