#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/material.h"

#include <span>

namespace keiko {

/// How glass turns the lines of sight through the middles of a camera's pixels, 3 channels
/// (docs/theory/glass.md#distortion). The first is the angle in mrad. The others are the direction
/// in which the eye looks behind the glass, right and up, as its slopes to the view. They are not a
/// number where no glass is seen, and where the reflection inside is total. `materials`: one a face
/// of the tracer's model. The tracer must have second derivatives. Throws Cancelled.
Image glass_deviations(const Tracer& seen, std::span<const Material> materials,
                       const Camera& camera, const Job& job = {});

} // namespace keiko
