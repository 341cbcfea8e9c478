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

/// Patches of a body, as often as they are placed, above which a drawing takes more than seconds.
constexpr std::size_t most_patches = 1000;

std::size_t placed_patches(const SurfaceModel& model) {
    std::size_t count = 0;
    for (const PlacedFace& face : placed_faces(model)) count += model.faces[face.face].patch_count;
    return count;
}

} // namespace

std::string report_drawing(const Scene& scene, std::span<const Check> findings, double join,
                           const Job& job) {
    if (placed_patches(scene.model) > most_patches) return "";
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
