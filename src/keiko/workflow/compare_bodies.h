#pragma once

#include "keiko/report/content/comparison.h"
#include "keiko/scene/symmetry.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/place_scene.h"

namespace keiko {

/// The views and lines that revisions are shown by.
struct CompareViewsOptions {
    std::vector<std::string> views;           ///< names; empty: three automatic ones of the former
    std::optional<std::filesystem::path> rig; ///< none: the former's own, or else placed on it
    int width = 0, height = 0;                ///< pixels; 0: as the former's scene has it
    FilmTolerance tolerance{};
    LineShiftOptions shift{};
};

struct CompareBodiesOptions {
    SceneOptions scene;
    CriteriaPreset preset;
    double join = 0.5; ///< mm
    BodyTolerance tolerance{};
    CompareOptions seams{};
    DeviationOptions deviation{};
    double reach = 0;                           ///< mm; 0: a fiftieth of the former's size
    std::optional<MirrorPlane> mirror{};        ///< take the mirror image of the latter
    bool align = false;                         ///< move the latter onto the former first
    std::optional<CompareViewsOptions> views{}; ///< none: geometry alone
};

/// A comparison, and the lamps of its views.
struct CompareResult {
    Comparison comparison;
    std::optional<LightRig> rig{};
};

/// Reads, measures and compares two models or scenes, in the same coordinates or aligned: a body
/// and its own mirror image tell how far it is from symmetric. Throws Error, Cancelled.
CompareResult compare_bodies(const std::filesystem::path& before,
                             const std::filesystem::path& after,
                             const CompareBodiesOptions& options = {}, const Job& job = {});

/// compare.html, compare.json, the pictures and, if there are views, rig.toml, for a folder: its
/// path is what the rig names its files from.
FolderContent comparison_files(const std::filesystem::path& folder, const CompareResult& result);

} // namespace keiko
