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

/// Registered hits as a file keeps them, and read from one. Throws Error for any other file.
std::string hits_text(const RegisteredHits& hits);
RegisteredHits read_hits(const std::filesystem::path& file);

struct PlaceOptions {
    std::vector<std::string> views;       ///< names; empty: the best one
    std::vector<std::string> faces;       ///< numbers or patterns of names; empty: all count
    std::optional<LightRig> rated{};      ///< tells of these lamps instead of placing others
    std::optional<RegisteredHits> hits{}; ///< instead of another look at the body; with their views
    PlacementOptions placement;           ///< but for its `sampling.faces` and `mirror`
    /// What lamps are symmetric about, where views and body are (placement.md#symmetry).
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
};

struct PlaceResult {
    std::vector<NamedView> views;
    Placement placement;
};

/// Hangs lamps where the body mirrors them into the eyes of all views. Throws Error for a pattern
/// that no face matches, and for hits of another body.
PlaceResult place_scene(const Scene& scene, const PlaceOptions& options = {}, const Job& job = {});

} // namespace keiko
