#include "keiko/keiko.h"

namespace keiko {
namespace {

std::vector<CPlane> planes_of(const LightRig& rig) {
    std::vector<CPlane> planes;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source)) planes.push_back(*plane);
    if (planes.empty())
        throw Error("", "rig '" + rig.name + "'", "has no C-plane, so that there are no lines");
    return planes;
}

LightRig rig_of(const Scene& scene, const LinesOptions& options) {
    if (options.rig) return read_rig(*options.rig);
    if (scene.rig) return *scene.rig;
    throw Error("", "--rig", "lines need a rig, as the scene has none of its own");
}

} // namespace

LineList find_lines(const Scene& scene, const LinesOptions& options, const Job& job) {
    const LightRig rig = rig_of(scene, options);
    const std::vector<CPlane> planes = planes_of(rig);
    LineList list{version(), rig.name, options.lines.look, {}};
    for (const NamedView& view : choose_views(scene, options.views, 1, job))
        list.views.push_back(
            {view.name, view.camera,
             surface_lines(scene.model, scene.seen(), planes, view.camera, options.lines, job)});
    return list;
}

} // namespace keiko
