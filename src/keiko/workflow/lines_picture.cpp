#include "keiko/workflow/lines_picture.h"

#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/workflow/find_lines.h"

namespace keiko {
namespace {

const Rgb line_color(0.1, 0.75, 1), pass_color(0.2, 0.85, 0.25), undecided_color(1, 0.75, 0.1),
    fail_color(1, 0.15, 0.1), not_judged_color(0.75, 0.75, 0.75);
constexpr std::size_t numbered = 9;

Rgb color_of(const std::optional<Verdict>& verdict) {
    if (!verdict) return not_judged_color;
    if (*verdict == Verdict::fail) return fail_color;
    return *verdict == Verdict::pass ? pass_color : undecided_color;
}

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
    Marker marker{.at = *pixel, .color = color_of(crossing.verdict), .radius = 2.5};
    if (bad && rank <= numbered) marker.label = std::to_string(rank), marker.radius = 8;
    overlay.markers.push_back(std::move(marker));
}

} // namespace

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
