#pragma once

#include "keiko/visibility/query/occluders.h"

#include <vector>

namespace keiko {

/// A model with nothing on some faces, one value a face. Patches keep their indices, which hits
/// have.
SurfaceModel without(SurfaceModel model, const std::vector<bool>& faces);

/// Occluders of a visible model without some faces, one value a face. `tracer` is of the whole
/// model. Throws Cancelled.
Occluders occluders_without(const SurfaceModel& model, const Tracer& tracer,
                            const std::vector<bool>& faces, const Job& job = {});

} // namespace keiko
