#include "keiko/film/overlay.h"
#include "keiko/find_lines.h"

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

} // namespace

Image lines_picture(const Scene& scene, const LinesOptions& options, const ViewLines& view,
                    const Job& job) {
    Overlay overlay;
    for (const SurfaceLine& piece : view.found.pieces) draw(overlay, view.camera, piece);
    const std::vector<LineCrossing>& crossings = view.found.crossings;
    // The worst come first, and are drawn last.
    for (std::size_t i = crossings.size(); i-- > 0;) {
        const auto pixel = project(view.camera, crossings[i].place);
        if (!pixel) continue;
        const bool bad = crossings[i].verdict && *crossings[i].verdict != Verdict::pass;
        Marker marker{.at = *pixel, .color = color_of(crossings[i].verdict), .radius = 2.5};
        if (bad && i < numbered) marker.label = std::to_string(i + 1), marker.radius = 8;
        overlay.markers.push_back(std::move(marker));
    }
    const LightRig rig = rig_for_lines(scene, options);
    return with_overlay(tone_mapped(render_view(scene, rig, view.camera, {}, job)), overlay);
}

} // namespace keiko
