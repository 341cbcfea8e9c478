#pragma once

#include "keiko/render/integrator.h"

namespace keiko {

/// Adds the light of the spots of a grid of eye rays, `width` x `height`, row by row, to their
/// samples. On smooth surfaces it is found at places four pixels apart and between them, and
/// taken linear from one to the next where those between are off by no more than `error` of what
/// the eye sees there; else closer, in the end for each ray. 0: for each ray.
void add_interpolated_light(const Integrator& integrator, int width, int height, double error,
                            EyeView& view);

} // namespace keiko
