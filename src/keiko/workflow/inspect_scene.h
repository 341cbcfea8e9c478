#pragma once

#include "keiko/base/output_folder.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/check_models.h"
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
    PlacementOptions placement; ///< except its `mirror`
    /// Symmetry of placed lamps, used if views and body are symmetric.
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
    PictureOptions picture;
    bool register_hits = false; ///< of the views, for InspectResult::hits
    CombOptions combs{};
};

/// Results of an inspection, for writing or display.
struct InspectResult {
    Report report;
    LightRig rig;
    std::optional<RegisteredHits> hits{};
    std::optional<Combs> combs{};                    ///< if any were requested
    std::vector<std::pair<std::string, Film>> films; ///< by view name
};

/// The main job: places the lamps, renders the views, measures the seams, and reports.
InspectResult inspect_scene(const Scene& scene, const InspectOptions& options = {},
                            const Job& job = {});

/// report.html, report.json, the pictures (PNG and EXR) and rig.toml, for a folder. The rig names
/// its files relative to the folder's path.
FolderContent result_files(const std::filesystem::path& folder, const InspectResult& result);

} // namespace keiko
