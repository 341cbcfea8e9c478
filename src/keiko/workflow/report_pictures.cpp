#include "keiko/workflow/report_pictures.h"

#include "keiko/base/job_steps.h"
#include "keiko/film/image_file.h"
#include "keiko/film/overlay.h"
#include "keiko/film/tone_mapping.h"
#include "keiko/scene/view.h"
#include "keiko/workflow/analysis_picture.h"
#include "keiko/workflow/curve_painter.h"
#include "keiko/workflow/picture_marks.h"
#include "keiko/workflow/seen_place.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

Image with_inflections(Image picture, const Film& film, const Inspection& inspection,
                       const Camera& camera) {
    const CurvePainter painter(film, camera);
    Overlay overlay;
    for (const MeasuredFace& face : inspection.faces)
        for (const InflectionCurve& curve : face.inflections)
            overlay.lines.push_back(
                {.points = painter.drawn(curve.points), .color = Rgb(0.02), .width = 1.6});
    return with_overlay(std::move(picture), overlay);
}

/// The place in a picture nearest to a pixel at which a marker covers no other: there, or one of
/// rings about it.
Vec2 free_place(const Vec2& pixel, const std::vector<PictureMarker>& markers,
                const Camera& camera) {
    constexpr double size = 48; // pixels: pages show pictures at half their size
    constexpr int directions = 8, rings = 4;
    const auto is_free = [&](const Vec2& at) {
        return std::none_of(markers.begin(), markers.end(), [&](const PictureMarker& other) {
            return std::hypot(at.x - other.x, at.y - other.y) < size;
        });
    };
    const auto is_inside = [&](const Vec2& at) {
        return at.x >= 0 && at.y >= 0 && at.x < camera.width && at.y < camera.height;
    };
    if (is_free(pixel)) return pixel;
    for (int ring = 1; ring <= rings; ++ring)
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            const Vec2 at = pixel + Vec2(std::cos(angle), std::sin(angle)) * (ring * size);
            if (is_inside(at) && is_free(at)) return at;
        }
    return pixel;
}

ReportPicture picture_of(const std::string& view, const std::string& kind, const Image& image) {
    return {.title = view + ", " + kind,
            .caption = "",
            .file_name = view + "-" + kind + ".png",
            .png = encode_png(image),
            .width = image.width,
            .height = image.height,
            .markers = {}};
}

/// The views of the shown faults, each once: three at most.
std::vector<std::string> views_of(std::span<const ShownItem> items) {
    constexpr std::size_t most = 3;
    std::vector<std::string> views;
    for (const ShownItem& item : items)
        if (item.fault && views.size() < most &&
            std::find(views.begin(), views.end(), item.fault->view) == views.end())
            views.push_back(item.fault->view);
    return views;
}

/// Dots on the seams of faults that an eye resolves.
Overlay seam_dots(std::span<const ShownItem> items, const Inspection& inspection,
                  const CurvePainter& painter) {
    Overlay overlay;
    for (const ShownItem& item : items)
        if (item.fault && !item.fault->fine)
            for (const std::uint32_t seam : item.fault->seams)
                dot_seam(inspection.seams[seam], painter, overlay);
    return overlay;
}

} // namespace

std::vector<PictureMarker> markers_in(const Scene& scene, std::span<const ShownItem> items,
                                      const Camera& camera) {
    std::vector<PictureMarker> markers;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Vec3& place = items[i].place;
        if (!seen_place(scene, camera, place)) continue;
        const Vec2 pixel = free_place(*project(camera, place), markers, camera);
        markers.push_back({static_cast<int>(i + 1), pixel.x, pixel.y});
    }
    return markers;
}

std::vector<ReportPicture> standing_pictures(const Scene& part, const Report& report,
                                             const Job& job) {
    const std::vector<ShownItem> items = shown_items(report);
    const std::vector<std::string> names = views_of(items);
    PictureOptions options{
        .aovs = look_layers(AnalysisMode::zebra), .max_depth = 0, .max_crossings = 0};
    options.aovs.push_back(Aov::depth);
    const Framing framing{.width = part.width, .height = part.height, .ground = part.ground()};
    JobSteps steps(job, static_cast<double>(names.size()));
    std::vector<ReportPicture> pictures;
    for (const std::string& name : names) {
        const Camera camera = frame_view(name, part.tracer.bounds(), framing);
        const Film film = render_view(part, {}, camera, options, steps.next(1, 1, name));
        const Image zebra = analysis_picture(AnalysisMode::zebra, film, camera, {});
        const Overlay dots = seam_dots(items, report.inspection, CurvePainter(film, camera));
        pictures.push_back(picture_of(name, "faults", with_overlay(zebra, dots)));
        pictures.back().title = name;
        pictures.back().markers = markers_in(part, items, camera);
    }
    return pictures;
}

ReportPicture report_picture(const std::string& title, const Image& display,
                             const std::vector<PictureMarker>& markers) {
    return {.title = title,
            .caption = "",
            .file_name = title + ".png",
            .png = encode_png(display),
            .width = display.width,
            .height = display.height,
            .markers = markers};
}

Image marked_image(const Film& film, const std::vector<PictureMarker>& markers) {
    Overlay overlay;
    for (const PictureMarker& marker : markers)
        overlay.markers.push_back({{marker.x, marker.y}, std::to_string(marker.number)});
    return with_overlay(tone_mapped(film), overlay);
}

std::vector<ReportPicture> curvature_pictures(std::span<const NamedView> views,
                                              std::span<const std::pair<std::string, Film>> films,
                                              const Inspection& inspection) {
    double full = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
        full =
            std::max(full, usual_curvature(AnalysisMode::gauss, films[i].second, views[i].camera));
    AnalysisOptions options;
    options.scale.range = ValueRange{-full, full};
    std::vector<ReportPicture> pictures;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Film& film = films[i].second;
        const Camera& camera = views[i].camera;
        const Image gauss = analysis_picture(AnalysisMode::gauss, film, camera, {}, options);
        pictures.push_back(picture_of(views[i].name, "curvature",
                                      with_inflections(gauss, film, inspection, camera)));
        pictures.push_back(picture_of(views[i].name, "zebra",
                                      analysis_picture(AnalysisMode::zebra, film, camera, {})));
    }
    return pictures;
}

} // namespace keiko
