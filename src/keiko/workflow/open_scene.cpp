#include "keiko/workflow/open_scene.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/base/text.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/rig/body_lamps.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/texels/scene_texels.h"
#include "keiko/volumes/scene_volumes.h"
#include "keiko/workflow/luminous_faces.h"
#include "keiko/workflow/painted_body.h"
#include "keiko/workflow/shadow_casters.h"

#include <algorithm>
#include <array>

namespace keiko {
namespace {

SurfaceModel on_ground(const SurfaceModel& body, const Box3& bounds, double z) {
    const std::array models{body, ground_plane(z, bounds)};
    return merge(models);
}

/// Occluders of a visible model: all but glass and lamps.
Occluders casters(const SurfaceModel& seen, const Tracer& tracer,
                  const std::vector<Material>& materials, const Job& job) {
    return occluders_without(seen, tracer, shadowless_faces(materials), job);
}

/// Traced form of a scene.
struct Traced {
    Tracer tracer; ///< of the body
    std::optional<Surroundings> surroundings{};
    std::optional<Occluders> occluders{};
};

Traced traced(const SurfaceModel& body, const std::vector<Material>& materials,
              const std::optional<GroundSpec>& ground, const SceneOptions& options,
              const Job& job) {
    const TracerOptions tracing{.second_derivatives = true, .clipping_only = options.clipping_only};
    Traced all{Tracer(body, tracing, job)};
    if (!ground) {
        if (options.shadows) all.occluders = casters(body, all.tracer, materials, job);
        return all;
    }
    const SurfaceModel seen = on_ground(body, all.tracer.bounds(), ground->z);
    all.surroundings = Surroundings{ground->z, materials, Tracer(seen, tracing, job)};
    all.surroundings->materials.push_back(ground->material);
    if (options.shadows)
        all.occluders = casters(seen, all.surroundings->tracer, all.surroundings->materials, job);
    return all;
}

std::optional<GroundSpec> ground_of(const Scene& scene) {
    if (!scene.surroundings) return {};
    return GroundSpec{scene.surroundings->ground, scene.surroundings->materials.back()};
}

std::optional<EnvironmentSpec> environment_of(const Scene& scene) {
    const Environment* environment = scene.maps ? scene.maps->environment() : nullptr;
    return environment ? std::optional(environment->spec()) : std::nullopt;
}

/// Takes the views, the lamps and the size of the pictures of an analysis.
void take_analysis(Scene& scene, const Analysis& analysis, const Job& job) {
    scene.analysis = followed_analysis(analysis, scene.model, job);
    if (scene.analysis->hidden().size() >= scene.model.faces.size())
        throw FieldError("analysis", "hides every face of the body");
    if (analysis.rig) {
        LightRig rig = *analysis.rig;
        add_body_lamps(scene.rig, rig);
        scene.rig = std::move(rig);
    }
    if (analysis.views.empty()) return;
    const Camera& first = analysis.views.front().camera;
    scene.set_picture_size(first.width, first.height);
}

} // namespace

void Scene::set_picture_size(int wide, int high) {
    width = wide, height = high;
    if (camera) camera->width = wide, camera->height = high;
}

namespace {

/// Prepares the maps of a scene's materials and its surroundings, if it has any, or the sides of
/// faces that emit light.
void take_maps(Scene& scene, const std::optional<EnvironmentSpec>& environment) {
    const std::vector<Material>& materials = scene.seen_materials();
    const auto needs_sides = [](const Material& material) {
        return !material.maps.empty() || material.emits != Rgb(0);
    };
    scene.maps.reset();
    if (environment || std::any_of(materials.begin(), materials.end(), needs_sides))
        scene.maps = std::make_shared<const SceneMaps>(materials, scene.model, environment);
}

/// Prepares the texels of a scene's materials, if they have any.
void take_texels(Scene& scene, const Job& job) {
    scene.texels.reset();
    if (have_texels(scene.materials))
        scene.texels = std::make_shared<const SceneTexels>(scene.model, scene.materials, job);
}

/// Adds the lights of bodies that are lamps.
void take_lamps(Scene& scene, std::vector<LightSource> lamps) {
    if (lamps.empty()) return;
    if (!scene.rig) scene.rig.emplace();
    scene.rig->sources.insert(scene.rig->sources.end(), lamps.begin(), lamps.end());
}

/// Weights of the steps of opening a scene.
constexpr double reading = 3, dividing = 1, building = 1, following = 1, classifying = 1;

double weight_of_preparing(const SceneOptions& options) {
    return dividing + building + (options.analysis ? following : 0);
}

/// The scene of a body that has been read.
Scene prepared(PaintedBody painted, const SceneSpec& spec, const SceneOptions& options,
               JobSteps& steps) {
    auto& [body, materials] = painted;
    std::vector<LightSource> lamps =
        luminous_faces(body, materials, options.load, steps.next(dividing));
    Traced all = traced(body, materials, spec.ground, options, steps.next(building));
    Scene scene{.model = std::move(body),
                .materials = std::move(materials),
                .tracer = std::move(all.tracer),
                .occluders = std::move(all.occluders),
                .camera = spec.camera,
                .view = spec.view,
                .rig = spec.rig,
                .background = spec.background,
                .width = spec.width,
                .height = spec.height,
                .surroundings = std::move(all.surroundings),
                .max_depth = spec.max_depth,
                .min_weight = spec.min_weight,
                .caustics = spec.caustics,
                .radiosity = spec.radiosity};
    take_lamps(scene, std::move(lamps));
    take_maps(scene, spec.environment);
    take_texels(scene, {});
    if (options.analysis) take_analysis(scene, *options.analysis, steps.next(following));
    return scene;
}

} // namespace

Scene open_scene(std::span<const std::filesystem::path> inputs, const SceneOptions& options,
                 const Job& job) {
    const SceneSpec spec = spec_of(inputs, options.material, options.frame);
    const double of_volumes = spec.volumes.empty() ? 0 : classifying;
    JobSteps steps(job, reading + weight_of_preparing(options) + of_volumes);
    PaintedBody body = read_body(spec, options.load, steps.next(reading));
    Scene scene = prepared(std::move(body), spec, options, steps);
    if (!spec.volumes.empty())
        scene.volumes = std::make_shared<const SceneVolumes>(spec.volumes, steps.next(classifying));
    scene.inputs = {inputs.begin(), inputs.end()};
    return scene;
}

Scene scene_of_model(SurfaceModel body, const SceneOptions& options, const Job& job) {
    const SceneSpec spec = spec_of({}, options.material);
    JobSteps steps(job, weight_of_preparing(options));
    std::vector<Material> materials(body.faces.size(), named_material(options.material));
    return prepared({std::move(body), std::move(materials)}, spec, options, steps);
}

std::string source_of(const Scene& scene) {
    std::vector<std::string> names;
    for (const std::filesystem::path& input : scene.inputs) names.push_back(input.string());
    return names.empty() ? scene.model.source : comma_list(names);
}

Scene moved_scene(Scene scene, const Affine& motion, const SceneOptions& options, const Job& job) {
    for (Instance& instance : scene.model.instances)
        instance.transform = motion * instance.transform;
    for (Material& material : scene.materials) place_material(motion, material);
    if (scene.rig) move_body_lamps(motion, *scene.rig);
    Traced all = traced(scene.model, scene.materials, ground_of(scene), options, job);
    scene.tracer = std::move(all.tracer);
    scene.surroundings = std::move(all.surroundings);
    scene.occluders = std::move(all.occluders);
    take_maps(scene, environment_of(scene));
    take_texels(scene, job);
    return scene;
}

SurfaceModel visible_model(const Scene& scene, SurfaceModel body) {
    if (!scene.surroundings) return body;
    return on_ground(body, scene.tracer.bounds(), scene.surroundings->ground);
}

PictureOptions picture_options(const Scene& scene, PictureOptions options) {
    options.max_depth = scene.max_depth.value_or(options.max_depth);
    options.min_weight = scene.min_weight.value_or(options.min_weight);
    return options;
}

Film render_view(const Scene& scene, const LightRig& rig, const Camera& camera,
                 PictureOptions options, const Job& job) {
    return render_part(scene, scene.picture(rig), camera, std::move(options), job);
}

Film render_part(const Scene& scene, const PictureScene& part, const Camera& camera,
                 PictureOptions options, const Job& job) {
    Film film = render(part, camera, picture_options(scene, std::move(options)), job);
    if (const auto layer = film.aovs.find(Aov::face); layer != film.aovs.end())
        for (float& value : layer->second.values)
            if (value >= 0)
                value = static_cast<float>(scene.face_id(static_cast<std::size_t>(value)));
    return film;
}

namespace {

/// The white_luminance() of a picture, from one of every eighth pixel a side.
double expected_white(const Scene& scene, const LightRig& rig, const Camera& camera,
                      PictureOptions options, const Job& job) {
    constexpr int coarser = 8;
    Camera coarse = camera;
    coarse.width = (camera.width + coarser - 1) / coarser;
    coarse.height = (camera.height + coarser - 1) / coarser;
    options.aovs.clear();
    options.edge_samples = 1, options.light_error = 0.02;
    return white_luminance(render_view(scene, rig, coarse, options, job));
}

} // namespace

Film render_to_show(const Scene& scene, const LightRig& rig, const Camera& camera,
                    PictureOptions options, const Job& job) {
    constexpr double coarse = 1, fine = 10;
    JobSteps steps(job, coarse + fine);
    options.white = expected_white(scene, rig, camera, options, steps.next(coarse));
    return render_view(scene, rig, camera, options, steps.next(fine));
}

std::optional<double> low_order_error(const Scene& scene) {
    const Environment* environment = scene.maps ? scene.maps->environment() : nullptr;
    if (!environment || !environment->spec().lights) return {};
    return environment->low_order_error();
}

double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye) {
    return scatterings_by_way_of(rig, scene.tracer.bounds().center(), eye);
}

} // namespace keiko
