#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <optional>
#include <string>

namespace keiko {

/// The first thing about a model that code working on it may not have to face: an index out of
/// range, a degree out of 1..max_degree, a number that is not finite, a weight that is not
/// positive. Nothing for a sound model.
std::optional<std::string> structural_fault(const SurfaceModel& model);

} // namespace keiko
