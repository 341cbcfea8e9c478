#pragma once

#include "keiko/placement/place_lamps.h"
#include "keiko/placement/registered_hits.h"
#include "keiko/scene/symmetry.h"
#include "keiko/workflow/choose_views.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// File text of registered hits, and its inverse. Throws Error for any other file.
std::string hits_text(const RegisteredHits& hits);
RegisteredHits read_hits(const std::filesystem::path& file);

struct PlaceOptions {
    std::vector<std::string> views;       ///< names; empty: the best one
    std::vector<std::string> faces;       ///< numbers or patterns of names; empty: all count
    std::optional<LightRig> rated{};      ///< rates these lamps instead of placing others
    std::optional<RegisteredHits> hits{}; ///< instead of tracing the body; with their views
    PlacementOptions placement;           ///< except its `sampling.faces` and `mirror`
    /// Symmetry of lamps, used if views and body are symmetric (placement.md#symmetry).
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
};

struct PlaceResult {
    std::vector<NamedView> views;
    Placement placement;
};

/// Places lamps where the body reflects them to the cameras of all views. Throws Error for a
/// pattern that no face matches, and for hits of another body.
PlaceResult place_scene(const Scene& scene, const PlaceOptions& options = {}, const Job& job = {});

} // namespace keiko
