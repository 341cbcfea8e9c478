#include "keiko/workflow/choose_lights.h"

#include "keiko/files/scene/rig_file.h"
namespace keiko {

ChosenLights choose_lights(const Scene& scene, const std::optional<std::filesystem::path>& rig,
                           std::span<const NamedView> views, const PlacementOptions& options,
                           const Job& job) {
    if (rig) return {read_rig(*rig)};
    if (scene.rig) return {*scene.rig};
    Placement placement = place_lamps(scene.tracer, scene.model, cameras_of(views), options, job);
    return {placement.rig, std::move(placement)};
}

} // namespace keiko
