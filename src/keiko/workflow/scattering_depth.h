#pragma once

#include "keiko/workflow/open_scene.h"

namespace keiko {

/// Mean number of scatterings of light on its way from a lamp of the rig past the middle of the
/// scene's body to the camera. Pictures hold singly scattered light only, and are wrong unless this
/// is well below 1.
double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye);

} // namespace keiko
