#pragma once

#include "keiko/workflow/place_scene.h"

namespace keiko {

/// The lamps that views of a scene are shown under.
struct ChosenLights {
    LightRig rig;
    std::optional<Placement> placement{}; ///< of lamps that were hung for these views
};

/// Those of a rig file, or else the scene's own, or else lamps hung where the body mirrors them
/// into the eyes of the views. Throws Error for a file that cannot be read.
ChosenLights choose_lights(const Scene& scene, const std::optional<std::filesystem::path>& rig,
                           std::span<const NamedView> views, const PlacementOptions& options,
                           const Job& job);

} // namespace keiko
