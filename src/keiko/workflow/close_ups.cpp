#include "keiko/workflow/close_ups.h"

#include "keiko/base/units.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/close_up_subjects.h"
#include "keiko/workflow/picture_marks.h"
#include "keiko/workflow/report_pictures.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace keiko {
namespace {

constexpr int close_up_width = 360, close_up_height = 240;

/// Camera at the same viewpoint, turned to the place and zoomed in.
Camera close_up_camera(const Scene& scene, const Camera& view, const Vec3& place) {
    Camera camera = view;
    camera.target = place;
    camera.width = close_up_width;
    camera.height = close_up_height;
    const double height = 0.08 * scene.tracer.bounds().size();
    const double distance = (place - view.eye).length();
    camera.vertical_fov = radians_to_degrees(2 * std::atan(height / (2 * distance)));
    camera.orthographic_height = height;
    return camera;
}

/// cd/m², of the brightest lamp of a plane; 0 without any.
double brightest_lamp(const LightRig& rig) {
    double brightest = 0;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source))
            brightest = std::max(brightest, luminance(plane->luminance));
    return brightest;
}

/// Share of the middle of a picture that mirrors lamps: it is brighter than diffuse light on paint.
double mirroring_share(const Film& film, double brightest) {
    constexpr double mirrored = 0.01; // of the lamp; a clear coat reflects 0.04 and more
    const Image& color = film.color;
    int bright = 0, all = 0;
    for (int y = color.height / 4; y < color.height * 3 / 4; ++y)
        for (int x = color.width / 4; x < color.width * 3 / 4; ++x, ++all) {
            const float* pixel = color.pixel(x, y);
            const Rgb seen(double{pixel[0]}, double{pixel[1]}, double{pixel[2]});
            if (luminance(seen) > mirrored * brightest) ++bright;
        }
    return static_cast<double>(bright) / std::max(all, 1);
}

/// True if the middle of a picture shows edges of lamps, or if there are none to show.
bool shows_lamps(const Film& film, const LightRig& rig) {
    constexpr double least = 0.02;
    const double brightest = brightest_lamp(rig);
    const double share = mirroring_share(film, brightest);
    return !(brightest > 0) || (share > least && share < 1 - least);
}

/// The marks of a subject in its close-up.
Overlay marks_of(const CloseUpSubject& subject, const Inspection& inspection, const Film& film,
                 const Camera& camera) {
    Overlay overlay;
    if (subject.of == CloseUp::Of::seam)
        dot_seam(inspection.seams[subject.index], CurvePainter(film, camera), overlay);
    if (subject.of == CloseUp::Of::face)
        for (const Check& look : inspection.looks)
            if (look.opening_length > 0 && look.worst.place == subject.place)
                ring_opening(look, camera, overlay);
    add_scale_bar(camera, subject.place, overlay);
    return overlay;
}

/// The stripes of the lamps, or zebra where the place mirrors none.
Image picture_of(const LightRig& rig, const Film& film, const Camera& camera) {
    return shows_lamps(film, rig) ? tone_mapped(film)
                                  : analysis_picture(AnalysisMode::zebra, film, camera, rig);
}

PictureOptions with_close_up_layers(PictureOptions options) {
    options.aovs = look_layers(AnalysisMode::zebra);
    options.aovs.push_back(Aov::depth);
    return options;
}

} // namespace

std::vector<CloseUp> close_ups(const Scene& scene, const LightRig& rig, const Report& report,
                               std::span<const NamedView> views, const PictureOptions& options,
                               std::size_t most, const Job& job) {
    const PictureOptions with_layers = with_close_up_layers(options);
    std::vector<CloseUp> pictures;
    for (const CloseUpSubject& subject : close_up_subjects(scene, report, views, most)) {
        const Camera camera = close_up_camera(scene, subject.view, subject.place);
        const std::string title = "close-up-" + std::to_string(pictures.size() + 1);
        const Film film = render_to_show(scene, rig, camera, with_layers, job);
        const Overlay marks = marks_of(subject, report.inspection, film, camera);
        const Image picture = with_overlay(picture_of(rig, film, camera), marks);
        pictures.push_back(
            {subject.of, subject.index, report_picture(title, picture, {}), subject.place});
    }
    return pictures;
}

} // namespace keiko
