#pragma once

#include "keiko/render/outline_refinement.h"

namespace keiko {

/// Adds the light of the spots of pixels in parts to their samples. Each smooth surface in a pixel
/// is lit once, at the place amid what is seen of it, as it is in a pixel of one ray.
void add_shared_light(const Integrator& integrator, RefinedPixels& refined);

} // namespace keiko
