#pragma once

#include "keiko/workflow/open_scene.h"

namespace keiko {

/// How often light is scattered on average on its way from a lamp of the rig past the middle of the
/// scene's body to the eye: pictures hold light that is scattered once, and are wrong where this is
/// not well below 1.
double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye);

} // namespace keiko
