#pragma once

#include "keiko/files/scene/preset_file.h"
#include "keiko/inspect/lines/surface_lines.h"
#include "keiko/report/content/line_list.h"
#include "keiko/scene/criteria_preset.h"
#include "keiko/workflow/choose_views.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace keiko {

struct LinesOptions {
    std::vector<std::string> views;           ///< names; empty: one, as choose_views has it
    std::optional<std::filesystem::path> rig; ///< none: the scene's own
    SurfaceLineOptions lines;
    CriteriaPreset preset = standard_presets().front();
    double join = 0.5; ///< mm
};

/// The reflection lines, highlight lines or isophotes of a rig's lamps that views of a scene show
/// on the body, joined over seams, measured and judged there. Throws Error without a rig, and for
/// one without C-planes.
LineList find_lines(const Scene& scene, const LinesOptions& options = {}, const Job& job = {});

/// The rig that the options name, or else the scene's own. Throws Error without either.
LightRig rig_for_lines(const Scene& scene, const LinesOptions& options);

/// Whether a rig has lamps whose lines can be followed.
bool has_lines(const LightRig& rig);

/// As find_lines, of a rig that has lines and in views that are chosen already.
LineList lines_under(const Scene& scene, const LightRig& rig, std::span<const NamedView> views,
                     const LinesOptions& options, const Job& job);

} // namespace keiko
