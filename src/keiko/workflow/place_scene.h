#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/placement/best_view.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/symmetry.h"
#include "keiko/workflow/choose_views.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// File text of registered hits, and its inverse. Throws Error for any other file.
std::string hits_text(const RegisteredHits& hits);
/// Registered hits of a file that hits_text wrote. Throws Error for any other file.
RegisteredHits read_hits(const std::filesystem::path& file);

/// Options of place_scene.
struct PlaceOptions {
    std::vector<std::string> views;       ///< names; empty: the best one
    std::vector<std::string> faces;       ///< numbers or patterns of names; empty: all count
    std::optional<LightRig> rated{};      ///< rates these lamps instead of placing others
    std::optional<RegisteredHits> hits{}; ///< instead of tracing the body; with their views
    PlacementOptions placement;           ///< except its `sampling.faces` and `mirror`
    /// Symmetry of lamps, used if views and body are symmetric (placement.md#symmetry).
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
};

/// Views that were served, and the lamps placed for them.
struct PlaceResult {
    std::vector<NamedView> views; ///< of the pictures, in order
    Placement placement;          ///< rig, coverage and unreached regions
};

/// Places lamps where the body reflects them to the cameras of all views. Throws Error for a
/// pattern that no face matches, and for hits of another body.
PlaceResult place_scene(const Scene& scene, const PlaceOptions& options = {}, const Job& job = {});

/// The symmetry plane of the lamps, if there is one: all cameras' eyes and axes lie on it, and the
/// faces that count lie within the choice's distance of their images. It is the chosen one or, if
/// it is to be found, the first of those across y, x and z through the first eye. nullopt if
/// `where` contains planes that are not symmetric. Throws Cancelled.
std::optional<MirrorPlane> placement_mirror(const SurfaceModel& model,
                                            std::span<const Camera> cameras,
                                            const PlacementOptions& options,
                                            const SymmetryChoice& choice, const Job& job);

/// The lamps of the pictures of a scene's views.
struct ChosenLights {
    LightRig rig;                         ///< all of them
    std::optional<Placement> placement{}; ///< of lamps that were placed for these views
};

/// The lamps of a rig file, or else the scene's own, or else lamps placed where the body reflects
/// them to the cameras of the views. Throws Error for a file that cannot be read.
ChosenLights choose_lights(const Scene& scene, const std::optional<std::filesystem::path>& rig,
                           std::span<const NamedView> views, const PlacementOptions& options,
                           const Job& job);

/// Writes placement.json, histogram-N.png for each plane and plan.png (body, lamps and cameras from
/// above) into a folder.
void write_placement(const std::filesystem::path& folder, const Scene& scene,
                     const PlaceResult& result, const Job& job = {});

} // namespace keiko
