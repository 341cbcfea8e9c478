#pragma once

#include "keiko/base/export.h"
#include "keiko/scene/stereo.h"
#include "keiko/workflow/open_scene.h"

namespace KEIKO_API keiko {

/// How the pictures of two eyes are shown as one.
enum class StereoLayout {
    side_by_side, ///< left eye on the left, as wide as both together
    anaglyph      ///< one over the other, for red and cyan glasses; without layers
};

/// Renders a scene for both eyes, as render_view does for each. Throws FieldError as stereo_pair.
Film render_stereo(const Scene& scene, const LightRig& rig, const Camera& camera,
                   const Stereo& stereo, StereoLayout layout, const PictureOptions& options,
                   const Job& job = {});

} // namespace keiko
