#include "keiko/api/render.h"

#include "keiko/api/results.h"
#include "keiko/base/log.h"
#include "keiko/base/output_file.h"
#include "keiko/cli/render_options.h"
#include "keiko/cli/session.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>
#include <sstream>

namespace keiko::cli {
namespace {

LightRig rig_of(const Scene& scene, const RenderArguments& arguments, const NamedView& view,
                const Job& job) {
    std::optional<std::filesystem::path> rig;
    if (arguments.rig != "auto") rig = arguments.rig;
    return choose_lights(scene, rig, std::span(&view, 1), {}, job).rig;
}

/// Renders an analysis picture. Only highlight lines use a rig's lamps; the rest of the light is
/// not computed. `shown`: the part of the scene that is rendered; lamps are those of the whole.
void render_look(const RenderArguments& arguments, const ChosenMode& chosen, const Scene& scene,
                 const Scene& shown, const NamedView& view, const Job& job) {
    const LightRig rig =
        chosen.look == AnalysisMode::highlight ? rig_of(scene, arguments, view, job) : LightRig{};
    write_png(arguments.output, scene_analysis(shown, view.camera, rig, chosen, job));
}

/// "picture.png" of frame 7 is "picture-0007.png".
std::filesystem::path numbered(const std::filesystem::path& path, int frame) {
    std::string digits = std::to_string(frame);
    digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
    return path.parent_path() / (path.stem().string() + "-" + digits + path.extension().string());
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

/// Tells what a picture of the surroundings cannot show.
void note_environment(const Scene& scene) {
    const auto error = low_order_error(scene);
    if (!error) return;
    std::ostringstream text;
    text << std::setprecision(2)
         << "the surroundings are a picture at infinity: mirrors show it without parallax, and "
         << "its light has no shadows and is off by up to " << 100 * *error
         << " % of the brightest, of its low orders alone";
    log_warning(text.str());
}

/// Half the distance of the eyes is a rule of thumb for what is fused with ease.
void warn_of_parallax(const Scene& scene, const Camera& camera, const Stereo& eyes) {
    const double parallax = largest_parallax(camera, eyes, scene.tracer.bounds());
    if (std::abs(parallax) <= eyes.eye_distance / 2) return;
    if (std::isinf(parallax))
        return log_warning("the body reaches beside the eyes: what is near them is hard to fuse");
    std::ostringstream text;
    text << std::setprecision(2) << "the body's parallax reaches " << parallax
         << " mm, more than half of the eyes' distance, which is hard to fuse: take a "
         << (parallax < 0 ? "nearer" : "farther") << " screen or a smaller distance of the eyes";
    log_warning(text.str());
}

/// The film of the camera's eye, or of both eyes; or of a mesh.
Film render_eyes(const RenderArguments& arguments, const Scene& scene, const Scene& shown,
                 const LightRig& rig, const Camera& camera, const PictureOptions& options,
                 const Job& job) {
    if (const auto look = arguments.mesh_look()) return mesh_film(shown, rig, camera, *look, job);
    const auto stereo = arguments.stereo();
    if (!stereo) return render_view(shown, rig, camera, options, job);
    if (camera.projection == Projection::perspective) warn_of_parallax(scene, camera, stereo->eyes);
    return render_stereo(shown, rig, camera, stereo->eyes, stereo->layout, options, job);
}

/// Renders the part that is shown under the lamps of the whole scene.
void render_lamps(const RenderArguments& arguments, const Scene& scene, const Scene& shown,
                  const NamedView& view, const Job& job) {
    const LightRig rig = rig_of(scene, arguments, view, job);
    warn_of_thick_fog(scene, rig, view.camera.eye);
    log_remarks(hidden_lamp_remarks(rig, scene.tracer.bounds()));
    note_environment(scene);
    PictureOptions options{.aovs = arguments.aovs(), .tubes = arguments.tubes()};
    options.light_error = arguments.light_error, options.edge_samples = arguments.edge_samples;
    options.gather_rays = arguments.gather_rays;
    const ShownQuantity quantity = arguments.quantity();
    if (quantity == ShownQuantity::illuminance) options.aovs.push_back(Aov::illuminance);
    const Film film = render_eyes(arguments, scene, shown, rig, view.camera, options, job);
    if (arguments.false_color)
        write_png(arguments.output,
                  false_color_picture(film, arguments.scale(), arguments.iso_lines, quantity));
    else
        write_film(arguments.output, film, arguments.mapping());
}

void withdraw_earlier(const RenderArguments& arguments) {
    std::vector<std::filesystem::path> inputs = arguments.scene.inputs;
    inputs.emplace_back(arguments.rig);
    inputs.emplace_back(arguments.view);
    inputs.push_back(arguments.scene.analysis);
    inputs.push_back(arguments.scene.solution);
    withdraw_results({.files = {arguments.output, arguments.hits}, .folders = {}}, inputs);
}

void render_picture(const RenderArguments& arguments, const Job& job) {
    withdraw_earlier(arguments);
    if (arguments.rig != "auto") read_rig_aloud(arguments.rig);
    std::vector<std::string> names;
    if (!arguments.view.empty()) names.push_back(arguments.view);
    require_view_names(names, arguments.scene.options.analysis);
    const Scene scene = arguments.scene.open(job);
    arguments.scene.warn_of_axes(scene, names);
    const NamedView view = choose_views(scene, names, 1, job).front();
    const std::optional<Scene> part = without_hidden_faces(scene, job);
    const Scene& shown = part ? *part : scene;
    if (const auto look = arguments.look())
        render_look(arguments, *look, scene, shown, view, job);
    else
        render_lamps(arguments, scene, shown, view, job);
    if (!arguments.hits.empty())
        write_text_file(arguments.hits,
                        hits_text(register_hits(shown.tracer, shown.model, {view}, job)));
}

/// Log of the frames of an animation that are complete, and of their inputs. It is a text file
/// beside their pictures, image-frames.txt for image-0000.png and on, with a line `frame key` for
/// each.
class FrameLog {
public:
    /// Reads the existing log. `picture` is the name of the pictures without their number.
    explicit FrameLog(const std::filesystem::path& picture);

    /// True if the frame is complete, with inputs of this key.
    bool holds(int frame, const std::string& key) const;
    /// Records that the frame is complete; its picture must be there. Throws Error if the file
    /// cannot be written.
    void note(int frame, const std::string& key);

private:
    std::filesystem::path file_;
    std::map<int, std::string> keys_;
};

FrameLog::FrameLog(const std::filesystem::path& picture)
    : file_(picture.parent_path() / (picture.stem().string() + "-frames.txt")) {
    std::ifstream lines(file_);
    int frame = 0;
    std::string key;
    while (lines >> frame >> key) keys_[frame] = key;
}

bool FrameLog::holds(int frame, const std::string& key) const {
    const auto found = keys_.find(frame);
    return found != keys_.end() && found->second == key;
}

void FrameLog::note(int frame, const std::string& key) {
    keys_[frame] = key;
    std::string text;
    for (const auto& [number, made_of] : keys_)
        text += std::to_string(number) + " " + made_of + "\n";
    write_text_file(file_, text);
}

void render_frames(const RenderArguments& arguments, const Frames& frames, const Job& job) {
    const std::string key = arguments.key();
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

int render(RenderArguments arguments, const Job& job) {
    arguments.take_analysis();
    arguments.require();
    if (const auto frames = arguments.frames())
        render_frames(arguments, *frames, job);
    else
        render_picture(arguments, job);
    return exit_pass;
}

} // namespace

void add_render(CLI::App& app, Session& session) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App& command = *app.add_subcommand("render", "render one picture under the lamps");
    arguments->add_to(command);
    command.footer("Example: keiko render hood.step -o hood.exr --view front --aov normal,depth");
    session.add_command(command, [arguments](const Job& job) { return render(*arguments, job); });
}

} // namespace keiko::cli
