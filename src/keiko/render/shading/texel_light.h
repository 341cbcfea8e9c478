#pragma once

#include "keiko/render/shading/direct_lighting.h"
#include "keiko/render/shading/glass_loss.h"
#include "keiko/render/shading/matter_loss.h"
#include "keiko/texels/lit_texels.h"

#include <vector>

namespace keiko {

/// Losses of light on its way to texels, beside shadows of surfaces.
struct LossBeforeTexels {
    const GlassLoss* glass; ///< null: none
    MatterLoss matter;
};

/// All lights of a rig as they arrive at a place in the air, in their order, each as if it came
/// from the middle of its lamp. `lights` are those of `rig`.
std::vector<ArrivingLight> arriving_lights(const PreparedRig& rig, const DirectLighting& lights,
                                           const LossBeforeTexels& loss, TubeModel tubes,
                                           const Vec3& place);

} // namespace keiko
