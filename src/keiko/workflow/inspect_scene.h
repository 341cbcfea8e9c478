#pragma once

#include "keiko/base/output_folder.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/body_combs.h"
#include "keiko/workflow/place_scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keiko {

struct InspectOptions {
    std::vector<std::string> views;           ///< names; empty: three automatic ones
    std::optional<std::filesystem::path> rig; ///< none: the scene's own, or else placed
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5;          ///< mm
    PlacementOptions placement; ///< but for its `mirror`
    /// What placed lamps are symmetric about, where views and body are.
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
    PictureOptions picture;
    bool register_hits = false; ///< of the views, for InspectResult::hits
    CombOptions combs{};
};

/// What an inspection made: to be written, or looked at.
struct InspectResult {
    Report report;
    LightRig rig;
    std::optional<RegisteredHits> hits{};
    std::optional<Combs> combs{};                    ///< where any were asked for
    std::vector<std::pair<std::string, Film>> films; ///< by view name
};

/// The main job: place the lamps, render the views, measure the seams, and tell of them.
InspectResult inspect_scene(const Scene& scene, const InspectOptions& options = {},
                            const Job& job = {});

/// report.html, report.json, the pictures (PNG and EXR) and rig.toml, for a folder: its path is
/// what the rig names its files from.
FolderContent result_files(const std::filesystem::path& folder, const InspectResult& result);

} // namespace keiko
