#include "keiko/workflow/open_scene.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/scene/animation.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>

namespace keiko {
namespace {

/// cd/m2 behind models that no scene file places: trims and outlines of dark paint stand out.
constexpr double studio_grey = 60;

bool names(const PaintOverride& paint, const Face& face) {
    return std::any_of(paint.faces.begin(), paint.faces.end(), [&](const std::string& pattern) {
        return fnmatch(pattern.c_str(), face.name.c_str(), 0) == 0;
    });
}

const Material& paint_of(const Face& face, const ModelSpec& part) {
    const Material* paint = &part.material;
    for (const PaintOverride& other : part.overrides)
        if (names(other, face)) paint = &other.material;
    return *paint;
}

/// An override that paints nothing is a misspelt name.
void require_matches(const SurfaceModel& model, const ModelSpec& part) {
    for (const PaintOverride& paint : part.overrides)
        if (std::none_of(model.faces.begin(), model.faces.end(),
                         [&](const Face& face) { return names(paint, face); }))
            throw Error(part.file.string(), "override",
                        "no face has a name like '" + paint.faces.front() + "'");
}

} // namespace

SceneSpec spec_of(std::span<const std::filesystem::path> inputs, const std::string& name,
                  double frame) {
    const Material material = named_material(name);
    for (const auto& input : inputs)
        if (input.extension() == ".toml") {
            if (inputs.size() > 1)
                throw Error(input.string(), "", "a scene file stands alone, without other models");
            return at_frame(read_scene(input), frame);
        }
    SceneSpec spec;
    spec.background = Rgb(studio_grey);
    for (const auto& input : inputs) spec.models.push_back({.file = input, .material = material});
    return spec;
}

PaintedBody read_body(const SceneSpec& spec, const LoadOptions& options, const Job& job) {
    std::vector<SurfaceModel> models;
    std::vector<Material> materials;
    for (const ModelSpec& part : spec.models) {
        SurfaceModel model = load_model(part.file, options, job);
        const Affine placed = part.transform.affine();
        for (Instance& instance : model.instances) instance.transform = placed * instance.transform;
        for (const Face& face : model.faces) materials.push_back(paint_of(face, part));
        require_matches(model, part);
        models.push_back(std::move(model));
    }
    return {merge(models), std::move(materials)};
}

namespace {

SurfaceModel on_ground(const SurfaceModel& body, const Box3& bounds, double z) {
    const std::array models{body, ground_plane(z, bounds)};
    return merge(models);
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
        if (options.shadows) all.occluders.emplace(body, all.tracer, job);
        return all;
    }
    const SurfaceModel seen = on_ground(body, all.tracer.bounds(), ground->z);
    all.surroundings = Surroundings{ground->z, materials, Tracer(seen, tracing, job)};
    all.surroundings->materials.push_back(ground->material);
    if (options.shadows) all.occluders.emplace(seen, all.surroundings->tracer, job);
    return all;
}

} // namespace

void Scene::set_picture_size(int wide, int high) {
    width = wide, height = high;
    if (camera) camera->width = wide, camera->height = high;
}

Scene open_scene(std::span<const std::filesystem::path> inputs, const SceneOptions& options,
                 const Job& job) {
    const SceneSpec spec = spec_of(inputs, options.material, options.frame);
    auto [body, materials] = read_body(spec, options.load, job);
    Traced all = traced(body, materials, spec.ground, options, job);
    return {.model = std::move(body),
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
            .min_weight = spec.min_weight};
}

Scene moved_scene(Scene scene, const Affine& motion, const SceneOptions& options, const Job& job) {
    for (Instance& instance : scene.model.instances)
        instance.transform = motion * instance.transform;
    std::optional<GroundSpec> ground;
    if (scene.surroundings)
        ground = {scene.surroundings->ground, scene.surroundings->materials.back()};
    Traced all = traced(scene.model, scene.materials, ground, options, job);
    scene.tracer = std::move(all.tracer);
    scene.surroundings = std::move(all.surroundings);
    scene.occluders = std::move(all.occluders);
    return scene;
}

PictureOptions picture_options(const Scene& scene, PictureOptions options) {
    options.max_depth = scene.max_depth.value_or(options.max_depth);
    options.min_weight = scene.min_weight.value_or(options.min_weight);
    return options;
}

Film render_view(const Scene& scene, const LightRig& rig, const Camera& camera,
                 const PictureOptions& options, const Job& job) {
    Film film = render(scene.picture(rig), camera, picture_options(scene, options), job);
    if (const auto layer = film.aovs.find(Aov::face); layer != film.aovs.end())
        for (float& value : layer->second.values)
            if (value >= 0)
                value = static_cast<float>(scene.face_id(static_cast<std::size_t>(value)));
    return film;
}

double scatterings_past_body(const Scene& scene, const LightRig& rig, const Vec3& eye) {
    return scatterings_by_way_of(rig, scene.tracer.bounds().center(), eye);
}

} // namespace keiko
