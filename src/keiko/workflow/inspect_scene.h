#pragma once

#include "keiko/base/export.h"
#include "keiko/base/output_folder.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/check_models.h"
#include "keiko/workflow/place_scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace KEIKO_API keiko {

/// Options of inspect_scene.
struct InspectOptions {
    std::vector<std::string> views;                     ///< names; empty: three automatic ones
    std::optional<std::filesystem::path> rig;           ///< none: the scene's own, or else placed
    CriteriaPreset preset = standard_presets().front(); ///< limits of the criteria
    double join = 0.5;                                  ///< mm
    PlacementOptions placement;                         ///< except its `mirror`
    /// Symmetry of placed lamps, used if views and body are symmetric.
    SymmetryChoice symmetry{SymmetryChoice::Kind::automatic};
    /// How pictures are made; with AOVs each is written as an EXR, too. The error of light
    /// is half a level of a display at most.
    PictureOptions picture{.aovs = {}, .light_error = 5e-3};
    std::size_t close_ups = 12;   ///< close-up pictures at most, those of the first screen first
    bool register_hits = false;   ///< of the views, for InspectResult::hits
    CombOptions combs{};          ///< sections and iso-curves; none unless requested
    bool joints = false;          ///< of panels that stand apart, too
    AcceptanceList acceptances{}; ///< findings that have no part in the verdict
    Scope scope{};                ///< part of the body that is judged
    /// Files of the preset and the acceptances, for Report::inputs; TOML files with those they
    /// name.
    std::vector<std::filesystem::path> settings{};
};

/// Results of an inspection, for writing or display.
struct InspectResult {
    Report report;                                   ///< verdict, findings and pictures
    LightRig rig;                                    ///< the lamps of the pictures
    std::optional<RegisteredHits> hits{};            ///< if they were requested
    std::optional<Combs> combs{};                    ///< if any were requested
    std::vector<std::pair<std::string, Film>> films; ///< by view name
    std::vector<Aov> aovs{};                         ///< those requested, for EXRs
    std::optional<Analysis> analysis{};              ///< of the scene, on its body
};

/// The main job: places the lamps, renders the views, measures the seams, and reports. Pictures and
/// lines are those of the body without the faces that the scene's analysis hides; sections of the
/// analysis are added to those requested.
InspectResult inspect_scene(const Scene& scene, const InspectOptions& options = {},
                            const Job& job = {});

/// report.html, report.json, the pictures, rig.toml and, if there is one, analysis.json, for a
/// folder. Pictures are PNGs, and EXRs
/// with the requested AOVs if there are any. The rig names its files relative to the folder's path.
FolderContent result_files(const std::filesystem::path& folder, const InspectResult& result);

} // namespace keiko
