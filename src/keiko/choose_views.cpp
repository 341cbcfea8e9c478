#include "keiko/keiko.h"

#include <algorithm>

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

std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job) {
    const Framing framing{.width = scene.width, .height = scene.height};
    std::vector<NamedView> views;
    for (const std::string& name : names) views.push_back(view_by_name(scene, name, framing, job));
    if (!views.empty()) return views;
    if (scene.camera) return {{"scene", *scene.camera}};
    if (scene.view) return {view_by_name(scene, *scene.view, framing, job)};
    return best_views(scene.tracer, scene.model, automatic, framing, job);
}

} // namespace keiko
