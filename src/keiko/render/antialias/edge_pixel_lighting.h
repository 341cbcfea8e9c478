#pragma once

#include "keiko/render/antialias/edge_refinement.h"

namespace keiko {

/// Adds the light of the shading points of pixels in parts, `width` in a row, to their samples.
/// Each smooth surface in a pixel is lit once, at the place amid what is seen of it, as it is in a
/// pixel of one ray; along straight outlines it is found at some of the pixels and between them,
/// off by no more than `error` of what the eye sees at those that are tested. 0: in each pixel.
void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined);

} // namespace keiko
