#include "keiko/workflow/report_drawing.h"

#include "keiko/base/job_steps.h"
#include "keiko/drawing/line_body.h"
#include "keiko/export/page_drawing.h"
#include "keiko/geometry/trim/material_bounds.h"
#include "keiko/workflow/choose_views.h"
#include "keiko/workflow/three_views.h"

#include <cstddef>
#include <vector>

namespace keiko {
namespace {

/// Share of the body's size between curves and chords: a fifth of a pixel of the page.
constexpr double chord_error = 2e-4;

/// Faces of a body, as often as they are placed, above which drawing three views takes one core
/// more than some ten seconds: 13 to 25 ms a face. Their number of patches matters less.
constexpr std::size_t most_faces = 500;

} // namespace

std::string drawing_remark(const SurfaceModel& model) {
    const std::size_t faces = placed_faces(model).size();
    if (faces <= most_faces) return "";
    return "No line drawing: of more than " + std::to_string(most_faces) +
           " faces it would hold up the report, and this body has " + std::to_string(faces) +
           "; keiko draw makes one.";
}

std::string report_drawing(const Scene& scene, std::span<const Check> findings, double join,
                           const Job& job) {
    if (const std::string remark = drawing_remark(scene.model); !remark.empty()) return remark;
    JobSteps steps(job, 1 + static_cast<double>(three_views().size()));
    const LineBody body(scene.model, scene.tracer, {.join = join, .chord_error = chord_error},
                        steps.next(1, 2));
    const Box3 box = material_bounds(scene.model);
    std::vector<Vec3> places;
    std::vector<std::string> tones;
    for (const Check& finding : findings) {
        places.push_back(finding.worst.place);
        tones.emplace_back(outcome_of(finding));
    }
    std::vector<SheetView> views;
    for (NamedView& view : choose_views(scene, three_views(), 1, job)) {
        view.camera.projection = Projection::orthographic;
        SheetView& drawn = views.emplace_back(SheetView{view.name, {}});
        drawn.strokes = body.strokes(view.camera, {}, false, steps.next(1, 2, view.name));
        if (image_box(drawn).empty()) return "";
        drawn.marks = marks_at(places, body, view.camera, false);
        add_dimensions(drawn, view.camera, box);
    }
    return page_drawing(views, tones);
}

} // namespace keiko
