// The analysis mode of RenderArguments and its settings, parsed from their texts.
#include "keiko/base/error.h"
#include "keiko/cli/option_values.h"
#include "keiko/cli/render_options.h"

#include <cmath>
#include <cstdio>

namespace keiko::cli {
namespace {

/// "P%"
std::optional<double> percentile(const std::string& text) {
    double percent = 0;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf%%%n", &percent, &end) != 1 || end == 0) return std::nullopt;
    const bool is_whole = static_cast<std::size_t>(end) == text.size();
    return is_whole && percent > 0 && percent <= 100 ? std::optional(percent) : std::nullopt;
}

AnalysisScale scale_of(const std::string& text, bool logarithmic) {
    const AnalysisScale scale{value_range(text), percentile(text)};
    if (logarithmic && scale.range && !(scale.range->low > 0))
        throw Error("", "--scale", "'" + text + "' is not MIN:MAX with 0 < MIN, in mm");
    if (!scale.range && !scale.percentile)
        throw Error("", "--scale",
                    "'" + text + "' is neither MIN:MAX with MIN < MAX nor P% with 0 < P <= 100");
    return scale;
}

/// Throws if the option of some modes is given with another.
void require_mode(bool suits, bool given, const char* option, const char* modes) {
    if (given && !suits) throw Error("", option, std::string("is for ") + modes);
}

MeshShadows shadows_by_name(const std::string& name) {
    if (name == "ray") return MeshShadows::ray;
    if (name == "scan-line") return MeshShadows::scan_line;
    if (name == "map") return MeshShadows::map;
    if (name == "polygons") return MeshShadows::polygons;
    return name == "volumes" ? MeshShadows::volumes : MeshShadows::none;
}

/// Range for full colours at `full`.
ValueRange range_to(AnalysisMode look, double full) {
    return {look == AnalysisMode::absolute ? 0 : -full, full};
}

} // namespace

std::optional<ChosenMode> RenderArguments::look() const {
    std::optional<StatedLook> stated;
    if (look_ != "lamps" && !mesh_look()) stated = look_from(look_);
    std::optional<ChosenMode> chosen;
    if (stated) chosen = ChosenMode{stated->mode};
    const auto is = [&](AnalysisMode mode) { return chosen && chosen->look == mode; };
    require_mode(is(AnalysisMode::draft), !pull_.empty(), "--pull", "--look draft");
    require_mode(is(AnalysisMode::draft), draft_.has_value(), "--draft", "--look draft");
    require_mode(is(AnalysisMode::section), !section_.empty(), "--section",
                 "--look curvature:section");
    require_mode(is(AnalysisMode::below_radius), radius_.has_value(), "--radius",
                 "--look below-radius");
    if (is(AnalysisMode::below_radius) && !radius_)
        throw Error("", "--look below-radius", "needs --radius MM");
    if (!chosen) return chosen;
    chosen->section = section_.empty() ? viewed_across_ : direction("--section", section_);
    chosen->options = look_options(*stated);
    return chosen;
}

std::optional<MeshLook> RenderArguments::mesh_look() const {
    const auto shading = mesh_shading_from(look_);
    const auto stated = [](const CLI::Option* option) { return option && option->count() > 0; };
    require_mode(shading.has_value(), !mesh_.empty(), "--mesh", "--look mesh:...");
    require_mode(shading.has_value(), stated(stated_hidden_), "--hidden-surfaces",
                 "--look mesh:...");
    require_mode(shading.has_value(), stated(stated_mesh_shadows_), "--mesh-shadows",
                 "--look mesh:...");
    if (!shading) return std::nullopt;
    MeshLook look{*shading};
    if (hidden_surfaces_ == "scan-line") look.hidden_surfaces = HiddenSurfaces::scan_line;
    if (hidden_surfaces_ == "painter") look.hidden_surfaces = HiddenSurfaces::painter;
    look.shadows = shadows_by_name(mesh_shadows_);
    look.mesh.load = load_options(scene);
    look.by_pixels = mesh_ == "pixel";
    if (!mesh_.empty() && !look.by_pixels) look.mesh.deviation = std::stod(mesh_);
    return look;
}

AnalysisOptions RenderArguments::look_options(const StatedLook& look) const {
    AnalysisOptions options;
    if (!pull_.empty()) options.pull = direction("--pull", pull_);
    options.draft = draft_.value_or(options.draft);
    options.radius = radius_.value_or(options.radius);
    require_mode(has_scale(look.mode) && !look.full, !scale_.empty(), "--scale",
                 "a --look with a legend and without '=C', or for --false-color");
    if (!scale_.empty()) options.scale = scale_of(scale_, look.mode == AnalysisMode::radius);
    if (look.full) options.scale.range = range_to(look.mode, *look.full);
    return options;
}

} // namespace keiko::cli
