#pragma once

#include "keiko/render/integrator.h"

namespace keiko {

/// Adds the light of the spots of single pixels to their samples: `cells` x `cells` eye rays each,
/// one pixel after the other. Each smooth surface in a pixel is lit once, at the place amid what
/// is seen of it, as it is in a pixel of one ray.
void add_shared_light(const Integrator& integrator, int cells, EyeView& view);

} // namespace keiko
