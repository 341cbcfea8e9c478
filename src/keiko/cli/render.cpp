#include "keiko/base/log.h"
#include "keiko/base/lower_case.h"
#include "keiko/base/output_file.h"
#include "keiko/cli/commands.h"
#include "keiko/cli/frame_log.h"
#include "keiko/cli/number_check.h"
#include "keiko/cli/output_place.h"
#include "keiko/cli/scene_options.h"
#include "keiko/input_key.h"
#include "keiko/look_picture.h"
#include "keiko/thick_fog.h"

#include <cmath>
#include <cstdio>
#include <iomanip>
#include <memory>
#include <sstream>

namespace keiko::cli {
namespace {

struct RenderArguments {
    SceneArguments scene;
    std::filesystem::path output, hits;
    std::string view, rig = "auto", aovs, look = "lamps";
    bool false_color = false, iso_lines = false;
    std::string scale, quantity = "luminance", penumbrae = "width", tone = "linear", frames;
    double light_error = PictureOptions().light_error;
    bool resume = false;
    ToneMapping mapping;
};

std::vector<Aov> aovs_of(const std::string& list) {
    if (list.empty()) return {};
    std::vector<Aov> aovs;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        aovs.push_back(aov_by_name(list.substr(begin, end - begin)));
        begin = end + 1;
    }
    return aovs;
}

bool is_png(const std::filesystem::path& path) {
    return lower_case(path.extension().string()) == ".png";
}

/// "MIN:MAX"
FalseColorScale scale_of(const std::string& text) {
    FalseColorScale scale;
    if (text.empty()) return scale;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf:%lf%n", &scale.minimum, &scale.maximum, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || !(scale.minimum > 0) ||
        !(scale.minimum < scale.maximum) || !std::isfinite(scale.maximum))
        throw Error("", "--scale", "'" + text + "' is not MIN:MAX with 0 < MIN < MAX");
    return scale;
}

ShownQuantity quantity_of(const RenderArguments& arguments) {
    return arguments.quantity == "illuminance" ? ShownQuantity::illuminance
                                               : ShownQuantity::luminance;
}

ToneMapping mapping_of(const RenderArguments& arguments) {
    using Curve = ToneMapping::Curve;
    ToneMapping mapping = arguments.mapping;
    mapping.curve = arguments.tone == "log"        ? Curve::logarithmic
                    : arguments.tone == "reinhard" ? Curve::reinhard
                                                   : Curve::linear;
    return mapping;
}

/// Nothing: under its lamps.
std::optional<Look> look_of(const RenderArguments& arguments) {
    for (const Look look : every_look())
        if (name_of(look) == arguments.look) return look;
    return std::nullopt;
}

std::vector<std::string> look_names() {
    std::vector<std::string> names{"lamps"};
    for (const Look look : every_look()) names.emplace_back(name_of(look));
    return names;
}

LightRig rig_of(const Scene& scene, const RenderArguments& arguments, const Camera& camera,
                const Job& job) {
    if (arguments.rig != "auto") return read_rig(arguments.rig);
    if (scene.rig) return *scene.rig;
    return place_lamps(scene.tracer, scene.model, camera, {}, job).rig;
}

/// Only highlight lines are of a rig's lamps; the rest of the light is not asked for.
void render_look(const RenderArguments& arguments, Look look, const Scene& scene,
                 const Camera& camera, const Job& job) {
    const LightRig rig =
        look == Look::highlight ? rig_of(scene, arguments, camera, job) : LightRig{};
    const Film film = render_view(scene, {}, camera, {.aovs = look_layers(), .max_depth = 0}, job);
    write_png(arguments.output, look_picture(look, film, camera, rig));
}

/// First and last.
struct Frames {
    int first = 0, last = 0;
};

constexpr int most_frames = 1000000;

/// "A:B"
Frames frames_of(const std::string& text) {
    Frames frames;
    int end = 0;
    if (std::sscanf(text.c_str(), "%d:%d%n", &frames.first, &frames.last, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || frames.first < 0 ||
        frames.last < frames.first || frames.last >= most_frames)
        throw Error("", "--frames", "'" + text + "' is not A:B with 0 <= A <= B < 1000000");
    return frames;
}

/// "picture.png" of frame 7 is "picture-0007.png".
std::filesystem::path numbered(const std::filesystem::path& path, int frame) {
    std::string digits = std::to_string(frame);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    return path.parent_path() / (path.stem().string() + "-" + digits + path.extension().string());
}

/// An .exr holds luminance as it is, and layers; a .png neither.
void require_output(const RenderArguments& arguments) {
    require_image_extension(arguments.output);
    const std::string file = arguments.output.string();
    const bool png = is_png(arguments.output);
    if (arguments.false_color && !png) throw Error(file, "", "--false-color makes a .png");
    if (arguments.mapping.ev && !png) throw Error(file, "", "--ev is for a .png");
    if (arguments.tone != "linear" && !png) throw Error(file, "", "--tone is for a .png");
    if (!arguments.aovs.empty() && png) throw Error(file, "", "--aov is for an .exr");
    if (look_of(arguments) && !png)
        throw Error(file, "", "--look " + arguments.look + " makes a .png");
    aovs_of(arguments.aovs), scale_of(arguments.scale);
    require_place_for_file(arguments.output);
    if (!arguments.hits.empty()) require_place_for_file(arguments.hits);
}

void warn_of_thick_fog(const Scene& scene, const LightRig& rig, const Vec3& eye) {
    const double times = scatterings_past_body(scene, rig, eye);
    if (times <= 1) return;
    std::ostringstream text;
    text << std::setprecision(2)
         << "the fog is thick: on the way from a lamp past the body to the eye light is "
         << "scattered " << times << " times on average, in the picture once";
    log_warning(text.str());
}

void render_lamps(const RenderArguments& arguments, const Scene& scene, const Camera& camera,
                  const Job& job) {
    const LightRig rig = rig_of(scene, arguments, camera, job);
    warn_of_thick_fog(scene, rig, camera.eye);
    PictureOptions options{.aovs = aovs_of(arguments.aovs)};
    if (arguments.penumbrae == "axis") options.tubes = TubeModel::preview;
    options.light_error = arguments.light_error;
    const ShownQuantity quantity = quantity_of(arguments);
    if (quantity == ShownQuantity::illuminance) options.aovs.push_back(Aov::illuminance);
    const Film film = render_view(scene, rig, camera, options, job);
    if (arguments.false_color)
        write_png(arguments.output, false_color_picture(film, scale_of(arguments.scale),
                                                        arguments.iso_lines, quantity));
    else
        write_film(arguments.output, film, mapping_of(arguments));
}

void render_picture(const RenderArguments& arguments, const Job& job) {
    if (arguments.rig != "auto") read_rig(arguments.rig);
    std::vector<std::string> names;
    if (!arguments.view.empty()) names.push_back(arguments.view);
    require_view_names(names);
    const Scene scene = arguments.scene.open(job);
    const NamedView view = choose_views(scene, names, 1, job).front();
    if (const auto look = look_of(arguments))
        render_look(arguments, *look, scene, view.camera, job);
    else
        render_lamps(arguments, scene, view.camera, job);
    if (!arguments.hits.empty())
        write_text_file(arguments.hits,
                        hits_text(register_hits(scene.tracer, scene.model, {view}, job)));
}

/// Of all that a picture is made of but the number of its frame.
std::string key_of(const RenderArguments& a) {
    std::vector<std::filesystem::path> inputs = a.scene.inputs;
    for (const std::string& name : {a.rig, a.view})
        if (std::filesystem::path(name).extension() == ".toml") inputs.emplace_back(name);
    const SceneOptions options = a.scene.scene_options();
    std::ostringstream settings;
    settings << std::setprecision(17) << options.material << '\n'
             << options.clipping_only << options.shadows << a.false_color << a.iso_lines << '\n'
             << a.light_error << '\n';
    for (const std::string& text :
         {a.scene.size, a.view, a.rig, a.aovs, a.scale, a.quantity, a.penumbrae, a.tone, a.look})
        settings << text << '\n';
    if (a.mapping.ev) settings << *a.mapping.ev;
    return input_key(inputs, "", options.load, settings.str());
}

void render_frames(const RenderArguments& arguments, const Job& job) {
    const Frames frames = frames_of(arguments.frames);
    const std::string key = key_of(arguments);
    FrameLog log(arguments.output);
    for (int frame = frames.first; frame <= frames.last; ++frame) {
        RenderArguments one = arguments;
        one.output = numbered(arguments.output, frame);
        one.scene.options.frame = frame;
        // Pictures appear whole or not at all.
        if (arguments.resume && std::filesystem::exists(one.output) && log.holds(frame, key))
            continue;
        render_picture(one, job);
        log.note(frame, key);
    }
}

int render(const RenderArguments& arguments, const Job& job) {
    require_output(arguments);
    if (arguments.frames.empty())
        render_picture(arguments, job);
    else
        render_frames(arguments, job);
    return exit_pass;
}

} // namespace

void add_render(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App& command = *app.add_subcommand("render", "render one picture under the lamps");
    arguments->scene.add_to(command, "MODEL|SCENE");
    arguments->scene.add_picture_size(command);
    arguments->scene.add_shadows(command);
    command.add_option("-o,--output", arguments->output, "image.exr (cd/m2, AOVs) or image.png")
        ->required();
    command
        .add_option(
            "--penumbrae", arguments->penumbrae,
            "of tubes: width, weighed over all of each, or axis, cut along the axis alone, sooner "
            "and off by up to some percent")
        ->check(CLI::IsMember({"axis", "width"}))
        ->needs("--shadows")
        ->capture_default_str();
    command
        .add_option("--light-error", arguments->light_error,
                    "share of what is seen by which the lamps' light on bases may be off for being "
                    "found a few pixels apart; 0: found in each pixel, slower")
        ->check(number_between(0, 0.1))
        ->capture_default_str();
    command.add_option("--view", arguments->view, "view by name, auto, or scene");
    command.add_option("--rig", arguments->rig, "rig file, or auto: the scene's, or placed")
        ->capture_default_str();
    command.add_option("--aov", arguments->aovs,
                       "layers of an .exr, comma-separated: luminance, normal, uv, face, patch, "
                       "depth, c_plane_uv, illuminance, curvature");
    auto* false_color =
        command.add_flag("--false-color", arguments->false_color,
                         "luminance by colour from blue to red, with a legend, for .png");
    command
        .add_option("--quantity", arguments->quantity,
                    "of the false colours: luminance in cd/m2, or illuminance in lx, direct light "
                    "alone as keiko illuminance tells it")
        ->check(CLI::IsMember({"luminance", "illuminance"}))
        ->needs(false_color)
        ->capture_default_str();
    command
        .add_option("--scale", arguments->scale, "MIN:MAX of false colours, cd/m2 or lx [1:10000]")
        ->needs(false_color);
    command
        .add_flag("--iso-lines", arguments->iso_lines,
                  "lines of equal value at the values of the legend, with their numbers")
        ->needs(false_color);
    command
        .add_option(
            "--tone", arguments->tone,
            "curve of a .png: linear, to judge stripes by; log and reinhard, to see dark and "
            "bright at once")
        ->check(CLI::IsMember({"linear", "log", "reinhard"}))
        ->excludes(false_color)
        ->capture_default_str();
    command
        .add_option("--ev", arguments->mapping.ev,
                    "exposure value of a .png [99 % of the body below white]")
        ->check(number_between(-100, 100));
    command
        .add_option("--look", arguments->look,
                    "what to look at, for .png: lamps, zebra, isophote, highlight (of the rig), or "
                    "curvature:gauss, :mean, :k1, :k2 by colour with a legend")
        ->check(CLI::IsMember(look_names()))
        ->option_text("NAME")
        ->excludes(false_color)
        ->capture_default_str();
    auto* frames = command.add_option("--frames", arguments->frames,
                                      "A:B, of a scene with [[animation]]: a picture of each, "
                                      "image-0000.png and on");
    command
        .add_option("--register", arguments->hits,
                    "file (.json) for what the picture mirrors, for keiko place --from")
        ->excludes(frames);
    command
        .add_flag("--resume", arguments->resume,
                  "leave out frames whose picture is there, made of the same files and options")
        ->needs(frames);
    command.footer("Example: keiko render hood.step -o hood.exr --view front --aov normal,depth");
    session.add_command(command, [arguments](const Job& job) { return render(*arguments, job); });
}

} // namespace keiko::cli
