#pragma once

#include "keiko/light/fog/transmittance.h"
#include "keiko/light/sky/sky_panels.h"

namespace keiko {

/// Luminance in cd/m2 that an open sky and its ground, scattered once along a camera ray, add at
/// the camera. Their light passes sky_distance of the medium, and no body hides any of it. To 1e-3
/// (docs/theory/sky.md#in-fog); `tolerance` along the ray is 1e-4 at the least.
Rgb scattered_light(const AttenuatedRay& camera_ray, const SkyLight& sky, double tolerance);

} // namespace keiko
