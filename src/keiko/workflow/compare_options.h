#pragma once

#include "keiko/base/export.h"
#include "keiko/report/content/comparison.h"
#include "keiko/scene/symmetry.h"
#include "keiko/workflow/find_lines.h"
#include "keiko/workflow/open_scene.h"
#include "keiko/workflow/place_scene.h"

namespace KEIKO_API keiko {

/// The views and lines in which revisions are compared.
struct CompareViewsOptions {
    std::vector<std::string> views;           ///< names; empty: three automatic ones of the former
    std::optional<std::filesystem::path> rig; ///< none: the former's own, or else placed on it
    int width = 0, height = 0;                ///< pixels; 0: the size of the former's scene
    FilmTolerance tolerance{};                ///< of the pictures
    LineShiftOptions shift{};                 ///< of the lines
};

/// Options of compare_bodies. Views and lamps of an analysis in `scene` are those of both bodies.
struct CompareBodiesOptions {
    SceneOptions scene;                         ///< of both models or scenes
    CriteriaPreset preset;                      ///< that both are inspected by
    double join = 0.5;                          ///< mm
    BodyTolerance tolerance{};                  ///< within which the bodies count as the same
    CompareOptions seams{};                     ///< of the seams
    DeviationOptions deviation{};               ///< of the surfaces
    double reach = 0;                           ///< mm; 0: a fiftieth of the former's size
    std::optional<MirrorPlane> mirror{};        ///< reflects the latter at this plane
    bool align = false;                         ///< moves the latter onto the former first
    Scope scope{};                              ///< part of both bodies that is compared
    std::optional<CompareViewsOptions> views{}; ///< none: geometry alone
};

/// A comparison, and the lamps of its views.
struct CompareResult {
    Comparison comparison;         ///< of the latter with the former
    std::optional<LightRig> rig{}; ///< none for geometry alone
    Diagnostics remarks{};         ///< on parts of an analysis that could not be followed
};

} // namespace keiko
