// Values of the options of RenderArguments, parsed from their texts.
#include "keiko/api/results.h"
#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/base/text.h"
#include "keiko/cli/outputs.h"
#include "keiko/cli/render_options.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace keiko::cli {
namespace {

constexpr int most_frames = 1000000;

bool is_png(const std::filesystem::path& path) {
    return lower_case(path.extension().string()) == ".png";
}

} // namespace

/// "MIN:MAX"
FalseColorScale RenderArguments::scale() const {
    FalseColorScale scale;
    if (scale_.empty() || look()) return scale;
    if (!false_color) throw Error("", "--scale", "is for --false-color, or a --look with a legend");
    int end = 0;
    if (std::sscanf(scale_.c_str(), "%lf:%lf%n", &scale.minimum, &scale.maximum, &end) != 2 ||
        static_cast<std::size_t>(end) != scale_.size() || !(scale.minimum > 0) ||
        !(scale.minimum < scale.maximum) || !std::isfinite(scale.maximum))
        throw Error("", "--scale", "'" + scale_ + "' is not MIN:MAX with 0 < MIN < MAX");
    return scale;
}

ShownQuantity RenderArguments::quantity() const {
    return quantity_ == "illuminance" ? ShownQuantity::illuminance : ShownQuantity::luminance;
}

ToneMapping RenderArguments::mapping() const {
    using Curve = ToneMapping::Curve;
    ToneMapping mapping;
    mapping.ev = ev_;
    mapping.curve = tone_ == "log"        ? Curve::logarithmic
                    : tone_ == "reinhard" ? Curve::reinhard
                                          : Curve::linear;
    return mapping;
}

TubeModel RenderArguments::tubes() const {
    if (penumbrae_ == "axis") return TubeModel::preview;
    return penumbrae_ == "exact" ? TubeModel::automatic : PictureOptions().tubes;
}

std::optional<ChosenStereo> RenderArguments::stereo() const {
    if (stereo_.empty()) return std::nullopt;
    return ChosenStereo{stereo_ == "anaglyph" ? StereoLayout::anaglyph : StereoLayout::side_by_side,
                        {.eye_distance = eye_distance_, .screen_distance = screen_distance_}};
}

/// "A:B"
std::optional<Frames> RenderArguments::frames() const {
    if (frames_.empty()) return std::nullopt;
    Frames frames;
    int end = 0;
    if (std::sscanf(frames_.c_str(), "%d:%d%n", &frames.first, &frames.last, &end) != 2 ||
        static_cast<std::size_t>(end) != frames_.size() || frames.first < 0 ||
        frames.last < frames.first || frames.last >= most_frames)
        throw Error("", "--frames", "'" + frames_ + "' is not A:B with 0 <= A <= B < 1000000");
    return frames;
}

void RenderArguments::take_analysis() {
    scene.read_analysis();
    if (!scene.options.analysis || stated_look_->count() > 0 || false_color) return;
    const std::vector<AnalysisView>& views = scene.options.analysis->views;
    const auto rendered = std::find_if(views.begin(), views.end(), [&](const AnalysisView& each) {
        return view.empty() || each.name == view;
    });
    if (rendered == views.end()) return;
    if (rendered->look == "faces")
        throw Error(scene.analysis.string(), "view " + rendered->name,
                    "shows faces by colour, which only keiko view draws: state another --look");
    look_ = rendered->look;
    viewed_across_ = rendered->across.value_or(viewed_across_);
}

/// An .exr holds unscaled luminance, and layers; a .png neither.
void RenderArguments::require() const {
    require_image_extension(output);
    const std::string file = output.string();
    const bool png = is_png(output);
    if (false_color && !png) throw Error(file, "", "--false-color makes a .png");
    if (ev_ && !png) throw Error(file, "", "--ev is for a .png");
    if (tone_ != "linear" && !png) throw Error(file, "", "--tone is for a .png");
    if (!aovs_.empty() && png) throw Error(file, "", "--aov is for an .exr");
    if (!aovs_.empty() && stereo_ == "anaglyph")
        throw Error("", "--aov", "an anaglyph has no layers: --stereo side-by-side has");
    if (const auto chosen = look()) require_look(*chosen);
    if (mesh_look()) require_mesh_look();
    aovs(), scale(), frames();
    require_place_for_file(output);
    if (!hits.empty()) require_place_for_file(hits);
}

/// An analysis mode shows the surface under any light; only highlight lines use a rig's lamps.
void RenderArguments::require_look(const ChosenMode& look) const {
    const std::string option = "--look " + std::string(name_of(look.look));
    if (!is_png(output)) throw Error(output.string(), "", option + " makes a .png");
    const auto refuse = [&](const CLI::Option* other) {
        if (other && other->count() > 0)
            throw Error("", option, "shows the surface by itself, without " + other->get_name());
    };
    for (const CLI::Option* other : of_lamps_) refuse(other);
    if (look.look != AnalysisMode::highlight) refuse(rig_);
}

void RenderArguments::require_mesh_look() const {
    for (const CLI::Option* other : of_surface_)
        if (other && other->count() > 0)
            throw Error("", "--look " + look_,
                        "shows a mesh under the lamps, without " + other->get_name());
    if (!aovs_.empty()) throw Error("", "--look " + look_, "has no layers for --aov");
}

std::string RenderArguments::key() const {
    std::vector<std::filesystem::path> inputs = scene.inputs;
    for (const std::string& name : {rig, view})
        if (std::filesystem::path(name).extension() == ".toml") inputs.emplace_back(name);
    for (const std::filesystem::path& file : {scene.analysis, scene.solution})
        if (!file.empty()) inputs.push_back(file);
    const SceneOptions options = scene.scene_options();
    std::ostringstream settings;
    settings << std::setprecision(17) << options.material << '\n'
             << options.clipping_only << options.shadows << false_color << iso_lines << '\n'
             << light_error << ' ' << edge_samples << ' ' << gather_rays << ' ' << eye_distance_
             << '\n';
    for (const std::string& text :
         {scene.size, view, rig, aovs_, scale_, quantity_, penumbrae_, tone_, look_, pull_,
          section_, stereo_, hidden_surfaces_, mesh_shadows_, mesh_})
        settings << text << '\n';
    for (const std::optional<double>& number : {ev_, draft_, radius_, screen_distance_}) {
        if (number) settings << *number;
        settings << '\n';
    }
    return input_key(inputs, "", options.load, settings.str());
}

} // namespace keiko::cli
