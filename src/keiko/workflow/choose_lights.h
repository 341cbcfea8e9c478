#pragma once

#include "keiko/workflow/place_scene.h"

namespace keiko {

/// The lamps of the pictures of a scene's views.
struct ChosenLights {
    LightRig rig;
    std::optional<Placement> placement{}; ///< of lamps that were placed for these views
};

/// The lamps of a rig file, or else the scene's own, or else lamps placed where the body reflects
/// them to the cameras of the views. Throws Error for a file that cannot be read.
ChosenLights choose_lights(const Scene& scene, const std::optional<std::filesystem::path>& rig,
                           std::span<const NamedView> views, const PlacementOptions& options,
                           const Job& job);

} // namespace keiko
