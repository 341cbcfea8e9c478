#include "keiko/workflow/painted_body.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/material_file.h"
#include "keiko/files/scene/scene_file.h"
#include "keiko/scene/animation.h"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <optional>

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

/// The models of files, each read once however often it is placed.
class ModelFiles {
public:
    /// Counts how often each file is placed.
    explicit ModelFiles(std::span<const ModelSpec> parts) {
        for (const ModelSpec& part : parts) ++files_[part.file].uses;
    }
    /// Model of the next use of a file; the last use takes it over.
    SurfaceModel next(const std::filesystem::path& path, const LoadOptions& options,
                      const Job& job) {
        File& file = files_[path];
        if (!file.model) file.model = load_model(path, options, job);
        if (--file.uses > 0) return *file.model;
        return std::move(*file.model);
    }

private:
    struct File {
        std::size_t uses = 0; ///< to come
        std::optional<SurfaceModel> model;
    };
    std::map<std::filesystem::path, File> files_;
};

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
    ModelFiles files(spec.models);
    for (const ModelSpec& part : spec.models) {
        SurfaceModel model = files.next(part.file, options, job);
        const Affine placed = part.transform.affine();
        for (Instance& instance : model.instances) instance.transform = placed * instance.transform;
        for (const Face& face : model.faces) {
            materials.push_back(paint_of(face, part));
            place_material(placed, materials.back());
        }
        require_matches(model, part);
        models.push_back(std::move(model));
    }
    for (const PrimitiveSpec& part : spec.primitives) {
        models.push_back(primitive_model(part.shape, part.name));
        materials.insert(materials.end(), models.back().faces.size(), part.material);
    }
    return {merge(models), std::move(materials)};
}

} // namespace keiko
