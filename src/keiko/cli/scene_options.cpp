#include "keiko/cli/scene_options.h"

#include "keiko/api/light.h"
#include "keiko/base/error.h"
#include "keiko/base/log.h"
#include "keiko/base/text.h"
#include "keiko/cli/session.h"

#include <algorithm>
#include <cstdio>

namespace keiko::cli {
namespace {

PictureSize parse_size(const std::string& text) {
    PictureSize size;
    int end = 0;
    constexpr int largest = 16384;
    if (std::sscanf(text.c_str(), "%dx%d%n", &size.width, &size.height, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || size.width < 1 || size.height < 1 ||
        size.width > largest || size.height > largest)
        throw Error("", "--size", "'" + text + "' is not WIDTHxHEIGHT with 1 to 16384 pixels");
    return size;
}

std::uint64_t bytes_of(double gibibytes) {
    return static_cast<std::uint64_t>(std::llround(gibibytes * 1073741824.0));
}

void tell_build(const Scene& scene) {
    const TracerStatistics& built = scene.tracer.statistics();
    log_detail(std::to_string(scene.model.patches.size()) + " patches in " +
               std::to_string(built.sub_patches) + " sub-patches (" +
               std::to_string(built.sub_patches_mixed) + " cut by trims), " +
               std::to_string(built.bytes) + " bytes, built in " +
               std::to_string(built.build_seconds) + " s");
    if (!scene.occluders) return;
    const Occluders::Statistics& hiding = scene.occluders->statistics();
    log_detail("shadows: " + std::to_string(hiding.silhouette_pieces) + " pieces of surfaces and " +
               std::to_string(hiding.boundary_pieces) + " of borders, made ready in " +
               std::to_string(hiding.build_seconds) + " s");
}

/// Gives the scene the reflected light of a solution's file.
void take_light(Scene& scene, const std::filesystem::path& file) {
    const RadiositySolution solution = read_solution(file);
    take_solution(scene, solution, file.string());
    log_detail(file.string() + ": " + std::to_string(solution.elements) + " elements, " +
               std::to_string(solution.factor_rows) +
               " rows of form factors, of which none is computed anew");
}

} // namespace

std::vector<Aov> aovs_by_names(const std::string& names) {
    std::vector<Aov> aovs;
    for (std::size_t begin = 0; !names.empty() && begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        const std::string name = names.substr(begin, end - begin);
        const Aov aov = aov_by_name(name);
        if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end())
            throw Error("", "aov", "\"" + name + "\" is asked for twice");
        aovs.push_back(aov);
        begin = end + 1;
    }
    return aovs;
}

void add_load_options(CLI::App& command, SceneArguments& arguments) {
    command.add_option(
        "--unit", arguments.options.load.unit,
        "length unit of the file's numbers, whatever the file says (mm, cm, m, in, ft)");
    command.add_option("--axes", arguments.options.load.axes,
                       "axes of the file that point rearwards, to the right and up: x,-z,y where y "
                       "is up and z to the left [x,y,z]");
    command.add_option("--import-timeout", arguments.import_timeout, "seconds to read one model")
        ->check(number_between(0.001, 1e6))
        ->capture_default_str();
    command
        .add_option("--import-memory", arguments.import_memory,
                    "GiB to read one model [16, or the machine's memory where that is less]")
        ->check(number_between(0.001, 1e6));
    command.add_option("--cache", arguments.options.load.cache,
                       "folder that keeps models as they were read, for the next time");
    command
        .add_option("--cache-limit", arguments.cache_limit,
                    "GiB of models in that folder; the least recently used are removed beyond it")
        ->check(number_between(0.001, 1e6))
        ->capture_default_str();
}

LoadOptions load_options(const SceneArguments& arguments) {
    LoadOptions options = arguments.options.load;
    options.timeout = std::chrono::milliseconds(std::llround(arguments.import_timeout * 1e3));
    if (arguments.import_memory) options.memory_limit = bytes_of(*arguments.import_memory);
    options.cache_limit = bytes_of(arguments.cache_limit);
    return options;
}

void log_remarks(const Diagnostics& remarks) {
    for (const Diagnostic& remark : remarks)
        log_warning(one_line(remark.entity + ": " + remark.message));
}

LightRig read_rig_aloud(const std::filesystem::path& file) {
    LightRig rig = read_rig(file);
    log_remarks(luminaire_remarks(rig));
    return rig;
}

void SceneArguments::add_to(CLI::App& command, const std::string& what) {
    command.add_option(what, inputs, "model files of one body, or one scene file (.toml)")
        ->required();
    add_reading(command);
}

void SceneArguments::add_reading(CLI::App& command) {
    command.add_option("--material", options.material, "paint of models that no scene file paints")
        ->capture_default_str();
    command
        .add_option("--intersector", intersector,
                    "proving: rays meet surfaces with proof, fast; clipping: Bezier clipping "
                    "alone, to check it by")
        ->check(CLI::IsMember({"proving", "clipping"}))
        ->capture_default_str();
    add_load_options(command, *this);
}

void SceneArguments::add_picture_size(CLI::App& command) {
    command.add_option("--size", size, "picture size in pixels, WIDTHxHEIGHT [960x540]");
}

void SceneArguments::add_shadows(CLI::App& command) {
    command.add_flag("--shadows", options.shadows, "bodies cast shadows; takes many times as long");
}

void SceneArguments::add_analysis(CLI::App& command) {
    command
        .add_option("--analysis", analysis,
                    "file that keiko view saved (.json): its views, lamps, hidden faces, sections "
                    "and notes, on this body")
        ->check(not_empty());
}

CLI::Option* SceneArguments::add_solution(CLI::App& command) {
    return command
        .add_option("--solution", solution,
                    "of keiko radiosity for this scene: its reflected light, in the place of "
                    "ambient light")
        ->type_name("FILE")
        ->check(not_empty());
}

void SceneArguments::read_analysis() {
    if (analysis.empty()) return;
    options.analysis = keiko::read_analysis(analysis);
    if (options.analysis->rig) log_remarks(luminaire_remarks(*options.analysis->rig));
}

SceneOptions SceneArguments::scene_options() const {
    SceneOptions all = options;
    all.load = load_options(*this);
    all.clipping_only = intersector == "clipping";
    return all;
}

PictureSize SceneArguments::picture_size() const {
    return size.empty() ? PictureSize{} : parse_size(size);
}

Scene SceneArguments::open(const Job& job) const {
    const PictureSize wanted = picture_size();
    Scene scene = open_scene(inputs, scene_options(), job);
    tell_build(scene);
    for (const LostFace& face : scene.model.lost_faces)
        log_warning("face " + std::to_string(face.id) + " is missing: " + face.reason);
    const bool is_own_rig = scene.rig && !(options.analysis && options.analysis->rig);
    if (is_own_rig) log_remarks(luminaire_remarks(*scene.rig));
    if (scene.analysis) log_remarks(scene.analysis->remarks);
    if (!solution.empty()) take_light(scene, solution);
    if (wanted.width > 0) scene.set_picture_size(wanted.width, wanted.height);
    return scene;
}

void SceneArguments::warn_of_axes(const Scene& scene, std::span<const std::string> views) const {
    const auto by_name = [](const std::string& view) {
        return std::find(view_names().begin(), view_names().end(), view) != view_names().end();
    };
    const bool turned = !options.load.axes.empty() || inputs.front().extension() == ".toml";
    if (turned || std::none_of(views.begin(), views.end(), by_name)) return;
    if (const auto remark = axes_remark(scene.tracer.bounds()))
        log_warning("--" + remark->entity + ": " + remark->message);
}

} // namespace keiko::cli
