#include "keiko/workflow/find_lines.h"

#include "keiko/base/error.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/workflow/version.h"

namespace keiko {
namespace {

std::vector<CPlane> planes_of(const LightRig& rig) {
    std::vector<CPlane> planes;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source)) planes.push_back(*plane);
    return planes;
}

} // namespace

LightRig rig_for_lines(const Scene& scene, const LinesOptions& options) {
    if (options.rig) return read_rig(*options.rig);
    if (scene.rig) return *scene.rig;
    throw FieldError("rig", "lines need a rig, as the scene has none of its own");
}

bool has_lines(const LightRig& rig) {
    return !planes_of(rig).empty();
}

LineList lines_under(const Scene& scene, const LightRig& rig, std::span<const NamedView> views,
                     const LinesOptions& options, const Job& job) {
    const std::vector<CPlane> planes = planes_of(rig);
    LineList list{version(), rig.name, options.lines.look, options.preset, options.join, {}};
    const LineSeams seams(scene.model, options.join, job);
    for (const NamedView& view : views) {
        std::vector<SurfaceLine> pieces =
            surface_lines(scene.model, scene.seen(), planes, view.camera, options.lines, job);
        list.views.push_back({view.name, view.camera,
                              join_lines(scene.model, seams, std::move(pieces), planes, view.camera,
                                         options.lines.look, options.preset, job)});
    }
    return list;
}

LineList find_lines(const Scene& scene, const LinesOptions& options, const Job& job) {
    const LightRig rig = rig_for_lines(scene, options);
    if (!has_lines(rig))
        throw Error("", "rig '" + rig.name + "'", "has no C-plane, so that there are no lines");
    return lines_under(scene, rig, choose_views(scene, options.views, 1, job), options, job);
}

} // namespace keiko
