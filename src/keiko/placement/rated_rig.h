#pragma once

#include "keiko/placement/placement.h"
#include "keiko/placement/view_samples.h"

#include <vector>

namespace keiko {

/// What the lamps of a given rig do for what pictures of `picture_height` pixels saw of the model:
/// the same figures as of a placed one. Spotlights and suns are passed over. Throws Error for a rig
/// without C-planes, and where the pictures see no surface.
Placement rated_rig(std::vector<ViewSample> seen, const SurfaceModel& model, int picture_height,
                    const LightRig& rig, const StripeSpacing& spacing = {});

} // namespace keiko
