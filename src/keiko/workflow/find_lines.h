#pragma once

#include "keiko/base/export.h"
#include "keiko/files/scene/preset_file.h"
#include "keiko/film/film.h"
#include "keiko/inspect/lines/surface_lines.h"
#include "keiko/report/content/line_list.h"
#include "keiko/scene/criteria_preset.h"
#include "keiko/workflow/choose_views.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Options of find_lines.
struct LinesOptions {
    std::vector<std::string> views;                     ///< names; empty: one, as in choose_views
    std::optional<std::filesystem::path> rig;           ///< none: the scene's own
    SurfaceLineOptions lines;                           ///< of the search on the surfaces
    CriteriaPreset preset = standard_presets().front(); ///< limits of the crossings
    double join = 0.5;                                  ///< mm
    Scope scope{};                                      ///< part of the body that is judged
};

/// The reflection lines, highlight lines or isophotes of a rig's lamps on the body in views of a
/// scene, joined over seams, measured and judged there. Throws Error without a rig, and for one
/// without lines of that kind.
LineList find_lines(const Scene& scene, const LinesOptions& options = {}, const Job& job = {});

/// Lines as in find_lines in one view, under a rig at hand: views and rig of the options are not
/// read. Throws Error for a rig without lines of that kind.
LineList lines_in_view(const Scene& scene, const LightRig& rig, const NamedView& view,
                       const LinesOptions& options = {}, const Job& job = {});

/// The rig of the options, or else the scene's own. Throws Error without either.
LightRig rig_for_lines(const Scene& scene, const LinesOptions& options);

/// True if a rig has lamps whose lines of a kind can be followed: rows of tubes, or panels unless
/// they are isophotes.
bool has_lines(const LightRig& rig, LineLook look = LineLook::reflection);

/// Lines as in find_lines, for a rig that has lines, for chosen views and for limits of the faces
/// that are known: the preset and the scope of the options are not read.
LineList lines_under(const Scene& scene, const LightRig& rig, std::span<const NamedView> views,
                     const LinesOptions& options, const FaceLimits& limits, const Job& job);

/// The picture of one view of a list with its lines drawn over it and their crossings marked by
/// verdict, the worst of the list numbered by their rank.
Image with_lines(const Film& film, const LineList& list, std::size_t view);

/// The stripes of the lamps in one view of a list, with its lines drawn over them and their
/// crossings marked by verdict. The worst of the list are numbered as in the table.
Image lines_picture(const Scene& scene, const LinesOptions& options, const LineList& list,
                    std::size_t view, const Job& job = {});

} // namespace keiko
