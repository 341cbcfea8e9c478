#include "keiko/workflow/hidden_faces.h"

#include "keiko/workflow/shadow_casters.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace keiko {
namespace {

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> ids) {
    std::sort(ids.begin(), ids.end());
    return ids;
}

/// True for each face of the visible geometry that is hidden.
std::vector<bool> hidden_in(const Scene& scene, std::span<const std::uint32_t> ids) {
    require_faces(scene.model, ids);
    const std::vector<std::uint32_t> hidden_ids = sorted({ids.begin(), ids.end()});
    std::vector<bool> hidden(scene.seen_materials().size(), false);
    for (std::size_t i = 0; i < scene.model.faces.size(); ++i)
        hidden[i] =
            std::binary_search(hidden_ids.begin(), hidden_ids.end(), scene.model.faces[i].id);
    return hidden;
}

} // namespace

void require_faces(const SurfaceModel& model, std::span<const std::uint32_t> ids) {
    std::vector<std::uint32_t> known;
    for (const Face& face : model.faces) known.push_back(face.id);
    known = sorted(std::move(known));
    for (const std::uint32_t id : ids)
        if (!std::binary_search(known.begin(), known.end(), id))
            throw FieldError("hidden", "there is no face " + std::to_string(id));
}

Tracer seen_without(const Scene& scene, std::span<const std::uint32_t> ids) {
    return ids.empty() ? scene.seen() : scene.seen().without(hidden_in(scene, ids));
}

std::optional<Occluders> occluders_without(const Scene& scene, std::span<const std::uint32_t> ids,
                                           const Job& job) {
    if (!scene.occluders) return {};
    std::vector<bool> clear = shadowless_faces(scene.seen_materials());
    const std::vector<bool> hidden = hidden_in(scene, ids);
    for (std::size_t i = 0; i < clear.size(); ++i) clear[i] = clear[i] || hidden[i];
    return occluders_without(visible_model(scene, scene.model), scene.seen(), clear, job);
}

Scene without_faces(const Scene& scene, std::span<const std::uint32_t> ids, const Job& job) {
    std::vector<bool> hidden = hidden_in(scene, ids);
    Scene part = scene;
    if (part.surroundings) part.surroundings->tracer = scene.surroundings->tracer.without(hidden);
    hidden.resize(scene.model.faces.size());
    part.tracer = scene.tracer.without(hidden);
    part.model = without(std::move(part.model), hidden);
    part.occluders = occluders_without(scene, ids, job);
    return part;
}

std::optional<Scene> without_hidden_faces(const Scene& scene, const Job& job) {
    if (!scene.analysis || scene.analysis->analysis.hidden.empty()) return {};
    return without_faces(scene, scene.analysis->hidden(), job);
}

} // namespace keiko
