#include "keiko/workflow/hidden_faces.h"

#include <algorithm>

namespace keiko {
namespace {

/// True for each face of the model that is hidden.
std::vector<bool> hidden_among(const SurfaceModel& model, std::span<const std::uint32_t> ids) {
    std::vector<bool> hidden;
    for (const Face& face : model.faces)
        hidden.push_back(std::find(ids.begin(), ids.end(), face.id) != ids.end());
    return hidden;
}

SurfaceModel without(SurfaceModel model, const std::vector<bool>& hidden) {
    std::vector<Patch> patches;
    for (std::size_t i = 0; i < hidden.size(); ++i) {
        Face& face = model.faces[i];
        const auto first = model.patches.begin() + face.first_patch;
        if (hidden[i]) face.patch_count = face.loop_count = 0;
        face.first_patch = static_cast<std::uint32_t>(patches.size());
        patches.insert(patches.end(), first, first + face.patch_count);
    }
    model.patches = std::move(patches);
    std::erase_if(model.irregular_patches,
                  [&](const IrregularPatch& patch) { return hidden[patch.face]; });
    return model;
}

} // namespace

void require_faces(const SurfaceModel& model, std::span<const std::uint32_t> ids) {
    for (const std::uint32_t id : ids)
        if (std::none_of(model.faces.begin(), model.faces.end(),
                         [&](const Face& face) { return face.id == id; }))
            throw FieldError("hidden", "there is no face " + std::to_string(id));
}

Scene without_faces(const Scene& scene, std::span<const std::uint32_t> ids, const Job& job) {
    require_faces(scene.model, ids);
    return scene_of_body(scene, without(scene.model, hidden_among(scene.model, ids)), job);
}

std::optional<Scene> without_hidden_faces(const Scene& scene, const Job& job) {
    if (!scene.analysis || scene.analysis->analysis.hidden.empty()) return {};
    return without_faces(scene, scene.analysis->hidden(), job);
}

} // namespace keiko
