#include "keiko/cli/render_options.h"

#include "keiko/base/lower_case.h"
#include "keiko/base/output_file.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/output_place.h"
#include "keiko/input_key.h"

#include <algorithm>
#include <charconv>
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

std::vector<std::string> look_names() {
    std::vector<std::string> names{"lamps"};
    for (const Look look : every_look()) names.emplace_back(name_of(look));
    return names;
}

/// Of "curvature:gauss=1e-4" the name.
Look look_by_name(const std::string& name) {
    for (const Look look : every_look())
        if (name_of(look) == name) return look;
    const std::vector<std::string> names = look_names();
    throw Error("", "--look",
                "no look is called '" + name + "'; there are " + comma_list(names) +
                    did_you_mean(name, names));
}

double full_curvature(Look look, const std::string& text) {
    double full = 0;
    const char* end = text.data() + text.size();
    const auto [rest, fault] = std::from_chars(text.data(), end, full);
    if (!is_curvature(look) || fault != std::errc() || rest != end || !(full > 0) ||
        !std::isfinite(full))
        throw Error("", "--look",
                    "'" + std::string(name_of(look)) + "=" + text +
                        "' is not curvature:KIND=C with the curvature C > 0 of full colour");
    return full;
}

/// An empty text is what an option has that was not given.
CLI::Validator not_empty() {
    return {[](const std::string& text) { return std::string(text.empty() ? "is empty" : ""); },
            ""};
}

} // namespace

std::vector<Aov> RenderArguments::aovs() const {
    if (aovs_.empty()) return {};
    std::vector<Aov> aovs;
    for (std::size_t begin = 0; begin <= aovs_.size();) {
        const std::size_t end = std::min(aovs_.find(',', begin), aovs_.size());
        const std::string name = aovs_.substr(begin, end - begin);
        const Aov aov = aov_by_name(name);
        if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end())
            throw Error("", "aov", "\"" + name + "\" is asked for twice");
        aovs.push_back(aov);
        begin = end + 1;
    }
    return aovs;
}

/// "MIN:MAX"
FalseColorScale RenderArguments::scale() const {
    FalseColorScale scale;
    if (scale_.empty()) return scale;
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

std::optional<ChosenLook> RenderArguments::look() const {
    if (look_ == "lamps") return std::nullopt;
    const std::size_t sign = std::min(look_.find('='), look_.size());
    ChosenLook chosen{look_by_name(look_.substr(0, sign))};
    if (sign < look_.size()) chosen.full = full_curvature(chosen.look, look_.substr(sign + 1));
    return chosen;
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

/// An .exr holds luminance as it is, and layers; a .png neither.
void RenderArguments::require() const {
    require_image_extension(output);
    const std::string file = output.string();
    const bool png = is_png(output);
    if (false_color && !png) throw Error(file, "", "--false-color makes a .png");
    if (ev_ && !png) throw Error(file, "", "--ev is for a .png");
    if (tone_ != "linear" && !png) throw Error(file, "", "--tone is for a .png");
    if (!aovs_.empty() && png) throw Error(file, "", "--aov is for an .exr");
    if (const auto chosen = look()) require_look(*chosen);
    aovs(), scale(), frames();
    require_place_for_file(output);
    if (!hits.empty()) require_place_for_file(hits);
}

/// It shows the surface, whatever the light is; only highlight lines are of a rig's lamps.
void RenderArguments::require_look(const ChosenLook& look) const {
    const std::string option = "--look " + std::string(name_of(look.look));
    if (!is_png(output)) throw Error(output.string(), "", option + " makes a .png");
    const auto refuse = [&](const CLI::Option* other) {
        if (other && other->count() > 0)
            throw Error("", option, "shows the surface by itself, without " + other->get_name());
    };
    for (const CLI::Option* other : of_lamps_) refuse(other);
    if (look.look != Look::highlight) refuse(rig_);
}

std::string RenderArguments::key() const {
    std::vector<std::filesystem::path> inputs = scene.inputs;
    for (const std::string& name : {rig, view})
        if (std::filesystem::path(name).extension() == ".toml") inputs.emplace_back(name);
    const SceneOptions options = scene.scene_options();
    std::ostringstream settings;
    settings << std::setprecision(17) << options.material << '\n'
             << options.clipping_only << options.shadows << false_color << iso_lines << '\n'
             << light_error << '\n';
    for (const std::string& text :
         {scene.size, view, rig, aovs_, scale_, quantity_, penumbrae_, tone_, look_})
        settings << text << '\n';
    if (ev_) settings << *ev_;
    return input_key(inputs, "", options.load, settings.str());
}

void RenderArguments::add_to(CLI::App& command) {
    scene.add_to(command, "MODEL|SCENE");
    scene.add_picture_size(command);
    scene.add_shadows(command);
    command.add_option("-o,--output", output, "image.exr (cd/m2, AOVs) or image.png")->required();
    add_light(command);
    command
        .add_option("--aov", aovs_,
                    "layers of an .exr, comma-separated: luminance, normal, uv, face, patch, "
                    "depth, c_plane_uv, illuminance, curvature")
        ->check(not_empty());
    add_false_colors(command);
    add_display(command);
    add_frames(command);
}

void RenderArguments::add_light(CLI::App& command) {
    of_lamps_.push_back(command.get_option("--shadows"));
    of_lamps_.push_back(
        command
            .add_option(
                "--penumbrae", penumbrae_,
                "of tubes: width, weighed over all of each, but for thin bars and slits along it, "
                "which it may miss; exact, as keiko illuminance has it with --light-error 0, up to "
                "six times slower; or axis, cut along the axis alone, sooner and off by up to some "
                "percent")
            ->check(CLI::IsMember({"axis", "width", "exact"}))
            ->needs("--shadows")
            ->capture_default_str());
    of_lamps_.push_back(
        command
            .add_option(
                "--light-error", light_error,
                "share of what is seen by which the lamps' light on bases may be off for being "
                "found a few pixels apart; shadows narrower than two pixels may have holes, and "
                "up to eight on curved surfaces and in penumbrae of others, as narrow light amid "
                "shadows may anywhere, however small it is; 0: found in each pixel, slower")
            ->check(number_between(0, 0.1))
            ->capture_default_str());
    command.add_option("--view", view, "view by name, auto, or scene")->check(not_empty());
    rig_ = command.add_option("--rig", rig, "rig file, or auto: the scene's, or placed")
               ->check(not_empty())
               ->capture_default_str();
}

void RenderArguments::add_false_colors(CLI::App& command) {
    auto* flag = command.add_flag("--false-color", false_color,
                                  "luminance by colour from blue to red, with a legend, for .png");
    command
        .add_option("--quantity", quantity_,
                    "of the false colours: luminance in cd/m2, or illuminance in lx, direct light "
                    "alone as keiko illuminance tells it")
        ->check(CLI::IsMember({"luminance", "illuminance"}))
        ->needs(flag)
        ->capture_default_str();
    command.add_option("--scale", scale_, "MIN:MAX of false colours, cd/m2 or lx [1:10000]")
        ->check(not_empty())
        ->needs(flag);
    command
        .add_flag("--iso-lines", iso_lines,
                  "lines of equal value at the values of the legend, with their numbers")
        ->needs(flag);
}

void RenderArguments::add_display(CLI::App& command) {
    auto* false_colors = command.get_option("--false-color");
    of_lamps_.push_back(
        command
            .add_option(
                "--tone", tone_,
                "curve of a .png: linear, to judge stripes by; log and reinhard, to see dark and "
                "bright at once")
            ->check(CLI::IsMember({"linear", "log", "reinhard"}))
            ->excludes(false_colors)
            ->capture_default_str());
    of_lamps_.push_back(
        command.add_option("--ev", ev_, "exposure value of a .png [99 % of the body below white]")
            ->check(number_between(-100, 100))
            ->excludes(false_colors));
    command
        .add_option("--look", look_,
                    "what to look at, for .png: lamps, zebra, isophote, highlight (of the rig), or "
                    "curvature:gauss, :mean, :k1, :k2 by colour with a legend; curvature:gauss=C: "
                    "colours are full at C")
        ->option_text("NAME")
        ->excludes(false_colors)
        ->capture_default_str();
}

void RenderArguments::add_frames(CLI::App& command) {
    auto* frames = command
                       .add_option("--frames", frames_,
                                   "A:B, of a scene with [[animation]]: a picture of each, "
                                   "image-0000.png and on")
                       ->check(not_empty());
    command
        .add_option("--register", hits,
                    "file (.json) for what the picture mirrors, for keiko place --from")
        ->excludes(frames);
    command
        .add_flag("--resume", resume,
                  "leave out frames whose picture is there, made of the same files and options")
        ->needs(frames);
}

} // namespace keiko::cli
