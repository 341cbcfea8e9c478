#include "keiko/workflow/find_lines.h"

#include "keiko/base/error.h"
#include "keiko/base/job_steps.h"
#include "keiko/files/scene/rig_file.h"
#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/report/content/verdict_color.h"
#include "keiko/workflow/version.h"
#include "keiko/workflow/zoned_limits.h"

namespace keiko {

namespace {

const Rgb line_color(0.1, 0.75, 1);
constexpr std::size_t numbered = 9;

void draw(Overlay& overlay, const Camera& camera, const SurfaceLine& piece) {
    Polyline drawn{.points = {}, .color = line_color, .width = 1};
    for (const LinePoint& point : piece.line.points)
        if (const auto pixel = project(camera, point.place)) drawn.points.push_back(*pixel);
    overlay.lines.push_back(std::move(drawn));
}

void mark(Overlay& overlay, const Camera& camera, const LineCrossing& crossing, std::size_t rank) {
    const auto pixel = project(camera, crossing.place);
    if (!pixel) return;
    const bool bad = crossing.verdict && *crossing.verdict != Verdict::pass;
    Marker marker{.at = *pixel, .color = verdict_color(crossing.verdict), .radius = 2.5};
    if (bad && rank <= numbered) marker.label = std::to_string(rank), marker.radius = 8;
    overlay.markers.push_back(std::move(marker));
}

} // namespace

LightRig rig_for_lines(const Scene& scene, const LinesOptions& options) {
    if (options.rig) return read_rig(*options.rig);
    if (scene.rig) return *scene.rig;
    throw FieldError("rig", "lines need a rig, as the scene has none of its own");
}

bool has_lines(const LightRig& rig, LineLook look) {
    return !line_sources(rig, look).empty();
}

LineList lines_under(const Scene& scene, const LightRig& rig, std::span<const NamedView> views,
                     const LinesOptions& options, const FaceLimits& limits, const Job& job) {
    const std::vector<LineSource> sources = line_sources(rig, options.lines.look);
    LineList list{version(), rig.name, options.lines.look, limits.preset(), options.join, {}};
    list.sources = sources;
    if (limits.has_zones_or_scope()) list.scope = scope_of_faces(scene.model, limits);
    constexpr double pairing = 0.2; // of what a view takes
    constexpr int view_stages = 4;
    JobSteps steps(job, pairing + static_cast<double>(views.size()));
    const LineSeams seams(scene.model, options.join, steps.next(pairing, 2));
    for (const NamedView& view : views) {
        const Job of_view = steps.next(1, view_stages, view.name);
        std::vector<SurfaceLine> pieces =
            surface_lines(scene.model, scene.seen(), sources, view.camera, options.lines, of_view);
        list.views.push_back({view.name, view.camera,
                              join_lines(scene.model, seams, std::move(pieces), sources,
                                         view.camera, options.lines.look, limits, of_view)});
    }
    return list;
}

namespace {

void require_lines(const LightRig& rig, LineLook look) {
    if (has_lines(rig, look)) return;
    const bool isophote = look == LineLook::isophote;
    throw Error("", "rig '" + rig.name + "'",
                isophote ? "has no C-plane, so that there are no isophotes"
                         : "has neither a C-plane nor a panel, so that there are no lines");
}

} // namespace

LineList lines_in_view(const Scene& scene, const LightRig& rig, const NamedView& view,
                       const LinesOptions& options, const Job& job) {
    require_lines(rig, options.lines.look);
    constexpr double choosing = 1, following = 4;
    JobSteps steps(job, choosing + following);
    const FaceLimits limits = limits_in(scene, options.preset, options.scope, steps.next(choosing));
    return lines_under(scene, rig, {&view, 1}, options, limits, steps.next_of_steps(following));
}

LineList find_lines(const Scene& scene, const LinesOptions& options, const Job& job) {
    const LightRig rig = rig_for_lines(scene, options);
    require_lines(rig, options.lines.look);
    constexpr double choosing = 1, following = 4;
    JobSteps steps(job, choosing + following);
    const Job to_choose = steps.next(choosing, 2);
    const FaceLimits limits = limits_in(scene, options.preset, options.scope, to_choose);
    const std::vector<NamedView> views = choose_views(scene, options.views, 1, to_choose);
    return lines_under(scene, rig, views, options, limits, steps.next_of_steps(following));
}

Image with_lines(const Film& film, const LineList& list, std::size_t view) {
    Overlay overlay;
    const ViewLines& shown = list.views[view];
    for (const SurfaceLine& piece : shown.found.pieces) draw(overlay, shown.camera, piece);
    for (const LineCrossing& crossing : shown.found.crossings)
        if (!crossing.verdict) mark(overlay, shown.camera, crossing, 0);
    // The worst come first, and are drawn last.
    const std::vector<CrossingPlace> ranked = ranked_crossings(list);
    for (std::size_t i = ranked.size(); i-- > 0;)
        if (ranked[i].view == view) mark(overlay, shown.camera, ranked[i].in(list), i + 1);
    return with_overlay(tone_mapped(film), overlay);
}

Image lines_picture(const Scene& scene, const LinesOptions& options, const LineList& list,
                    std::size_t view, const Job& job) {
    const LightRig rig = rig_for_lines(scene, options);
    return with_lines(render_view(scene, rig, list.views[view].camera, {}, job), list, view);
}

} // namespace keiko
