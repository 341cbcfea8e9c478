#include "keiko/workflow/choose_views.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/scene_file.h"

#include <algorithm>

namespace keiko {
namespace {

Camera of_size(Camera camera, const Framing& framing) {
    camera.width = framing.width, camera.height = framing.height;
    return camera;
}

/// View named by the file's stem, like its pictures.
NamedView view_of_file(const std::filesystem::path& path, const Framing& framing) {
    return {path.stem().string(), of_size(read_view(path), framing)};
}

/// The view of that name of an analysis; null if there is none.
const AnalysisView* view_of_analysis(const Analysis& analysis, const std::string& name) {
    const auto& views = analysis.views;
    const auto found = std::find_if(views.begin(), views.end(),
                                    [&](const AnalysisView& view) { return view.name == name; });
    return found == views.end() ? nullptr : &*found;
}

NamedView view_by_name(const Scene& scene, const std::string& name, const Framing& framing,
                       const Job& job) {
    const AnalysisView* own =
        scene.analysis ? view_of_analysis(scene.analysis->analysis, name) : nullptr;
    if (own) return {name, of_size(own->camera, framing)};
    if (name == "auto") return best_view(scene.tracer, scene.model, framing, job);
    if (name == "scene") {
        if (!scene.camera) throw FieldError("views", "the scene has no camera of its own");
        return {name, of_size(*scene.camera, framing)};
    }
    if (is_view_file(name)) return view_of_file(name, framing);
    return {name, frame_view(name, scene.tracer.bounds(), framing)};
}

} // namespace

void require_different_names(std::span<const NamedView> views) {
    for (std::size_t i = 0; i < views.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (views[k].name == views[i].name)
                throw FieldError("views", "two views are called '" + views[i].name + "'");
}

void require_view_names(std::span<const std::string> names,
                        const std::optional<Analysis>& analysis) {
    const Box3 any{Vec3(0), Vec3(1)};
    for (const std::string& name : names) {
        if (analysis && view_of_analysis(*analysis, name)) continue;
        if (is_view_file(name))
            read_view(name);
        else if (name != "auto" && name != "scene")
            frame_view(name, any);
    }
}

std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, const Job& job) {
    return choose_views(scene, names, automatic, scene.width, scene.height, job);
}

std::vector<NamedView> choose_views(const Scene& scene, std::span<const std::string> names,
                                    int automatic, int width, int height, const Job& job) {
    const Framing framing{.width = width, .height = height, .ground = scene.ground()};
    std::vector<NamedView> views;
    for (const std::string& name : names) views.push_back(view_by_name(scene, name, framing, job));
    require_different_names(views);
    if (!views.empty()) return views;
    if (scene.analysis)
        for (const AnalysisView& view : scene.analysis->analysis.views)
            views.push_back({view.name, of_size(view.camera, framing)});
    if (!views.empty()) return views;
    if (scene.camera) return {{"scene", of_size(*scene.camera, framing)}};
    if (scene.view) return {view_by_name(scene, *scene.view, framing, job)};
    return best_views(scene.tracer, scene.model, automatic, framing, job);
}

} // namespace keiko
