#include "keiko/keiko.h"

namespace keiko {
namespace {

NamedView view_by_name(const Scene& scene, const std::string& name, const Framing& framing,
                       const Job& job) {
    if (name == "auto") return best_view(scene.tracer, scene.model, framing, job);
    if (name == "scene") {
        if (!scene.camera) throw Error("", "--view", "the scene has no camera of its own");
        return {name, *scene.camera};
    }
    return {name, frame_view(name, scene.tracer.bounds(), framing)};
}

} // namespace

void require_view_names(std::span<const std::string> names) {
    const Box3 any{Vec3(0), Vec3(1)};
    for (const std::string& name : names)
        if (name != "auto" && name != "scene") frame_view(name, any);
}

std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job) {
    Framing framing{.width = scene.width, .height = scene.height};
    if (scene.surroundings) framing.ground = scene.surroundings->ground;
    std::vector<NamedView> views;
    for (const std::string& name : names) views.push_back(view_by_name(scene, name, framing, job));
    if (!views.empty()) return views;
    if (scene.camera) return {{"scene", *scene.camera}};
    if (scene.view) return {view_by_name(scene, *scene.view, framing, job)};
    return best_views(scene.tracer, scene.model, automatic, framing, job);
}

} // namespace keiko
