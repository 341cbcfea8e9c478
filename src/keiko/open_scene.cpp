#include "keiko/io/scene_file.h"
#include "keiko/keiko.h"

namespace keiko {
namespace {

/// cd/m2 behind models that no scene file places: trims and outlines of dark paint stand out.
constexpr double studio_grey = 60;

SceneSpec spec_of(std::span<const std::filesystem::path> inputs, const SceneOptions& options) {
    for (const auto& input : inputs)
        if (input.extension() == ".toml") {
            if (inputs.size() > 1)
                throw Error(input.string(), "", "a scene file stands alone, without other models");
            return read_scene(input);
        }
    SceneSpec spec;
    spec.background = Rgb(studio_grey);
    for (const auto& input : inputs)
        spec.models.push_back({input, {}, named_material(options.material)});
    return spec;
}

} // namespace

std::string version() {
    return KEIKO_VERSION;
}

Scene open_scene(std::span<const std::filesystem::path> inputs, const SceneOptions& options,
                 const Job& job) {
    const SceneSpec spec = spec_of(inputs, options);
    std::vector<SurfaceModel> models;
    std::vector<Material> materials;
    for (const ModelSpec& part : spec.models) {
        SurfaceModel model = load_model(part.file, options.load, job);
        for (Instance& instance : model.instances)
            instance.transform = part.transform * instance.transform;
        materials.insert(materials.end(), model.instances.size(), part.material);
        models.push_back(std::move(model));
    }
    SurfaceModel body = merge(models);
    Tracer tracer(body, {.second_derivatives = true}, job);
    return {std::move(body), std::move(materials), std::move(tracer), spec.camera, spec.view,
            spec.rig,        spec.background,      spec.width,        spec.height};
}

Film render_view(const Scene& scene, const LightRig& rig, const Camera& camera,
                 const PictureOptions& options, const Job& job) {
    return render({scene.tracer, scene.materials, rig, scene.background}, camera, options, job);
}

} // namespace keiko
