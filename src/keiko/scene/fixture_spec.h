#pragma once

#include "keiko/scene/criteria_preset.h"
#include "keiko/scene/film_tolerance.h"
#include "keiko/scene/metric.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keiko {

/// What of a fixture is held against its baseline.
struct FixtureChecks {
    bool shape = true;    ///< area, centre, direction and borders of every face
    bool seams = true;    ///< every seam: length, gap, angle, curvature, verdicts
    bool lines = true;    ///< length of every lamp's reflection line, by view
    bool pictures = true; ///< every view: colour and layers

    bool operator==(const FixtureChecks&) const = default;
};

/// A fixture file's content (keiko-fixture/1), every path resolved: a body and what is guarded.
struct FixtureSpec {
    std::string name; ///< of the file, without its extension
    std::filesystem::path file;
    std::vector<std::filesystem::path> models; ///< files of one body, or one scene file
    std::optional<std::string> material;       ///< of models that no scene paints
    std::vector<std::string> views;            ///< names; empty: the scene's own
    std::optional<std::filesystem::path> rig;  ///< none: the scene's own, or else placed
    CriteriaPreset preset;
    double join = 0.5;               ///< mm
    int width = 96, height = 54;     ///< pixels
    std::vector<std::string> layers; ///< of the pictures, besides the colour
    bool shadows = false;
    FixtureChecks checks;
    MetricTolerances metric_tolerance;
    FilmTolerance film_tolerance;
};

/// The layers that a fixture may ask for: the AOVs that pictures are compared by.
inline const std::vector<std::string> fixture_layers{"normal", "face", "depth", "uv", "c_plane_uv"};

} // namespace keiko
