#pragma once

#include "keiko/base/export.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/drawing/sheet/sheet.h"
#include "keiko/inspect/combs/comb_sample.h"
#include "keiko/workflow/check_models.h"
#include "keiko/workflow/find_lines.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace KEIKO_API keiko {

/// Treatment of lines that the body itself hides.
enum class HiddenLines {
    remove, ///< nothing
    dash,   ///< thin dashed lines
    draw    ///< the same as of visible ones: a wireframe
};

/// Options of draw_scene.
struct DrawOptions {
    std::vector<std::string> views{}; ///< as in choose_views; empty: left, front and top
    bool perspective = false;         ///< from the views' own eyes; otherwise by parallel rays
    HiddenLines hidden = HiddenLines::remove; ///< treatment of hidden lines
    /// Kinds of curves that are left out, by name_of().
    std::vector<std::string> without{};
    double join = 0.5;       ///< mm, within which two borders are a seam
    double crease_angle = 1; ///< degrees, above which a seam is a crease at its sharpest place
    CombOptions curves{};    ///< sections and iso-curves to be drawn too
    std::optional<LightRig> rig{};        ///< whose reflection lines are drawn
    LineLook look = LineLook::reflection; ///< kind of those lines
    /// Limits that the body is judged by, its findings to be numbered in the views and listed
    /// beside the title block; nullopt: it is not judged.
    std::optional<CriteriaPreset> findings{};
    Vec2 paper{420, 297}; ///< mm
    std::string title{};  ///< empty: the names of the inputs
};

/// Size of a paper by its name, wider than high: "A4" to "A0". Throws Error for another name.
Vec2 paper_size(std::string_view name);

/// The line drawing of a scene's body in views, laid out on a sheet. Throws Error for views from
/// within the body in perspective, for a rig without C-planes, and Cancelled.
Sheet draw_scene(const Scene& scene, const DrawOptions& options = {}, const Job& job = {});

/// True if sheets can be written to a file of this name: it ends in .svg, .dxf or .pdf.
bool is_sheet_output(const std::filesystem::path& path);
/// Bytes of a sheet in the format of the file's ending. Throws Error for another ending.
std::string sheet_output(const Sheet& sheet, const std::filesystem::path& path);

} // namespace keiko
