#include "keiko/base/error.h"
#include "keiko/base/output_file.h"
#include "keiko/base/parallel.h"
#include "keiko/film/false_color.h"
#include "keiko/film/image_file.h"
#include "keiko/film/overlay.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/report/json/placement_json.h"
#include "keiko/workflow/place_scene.h"
#include "keiko/workflow/version.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

constexpr int histogram_size = 512, plan_width = 800, plan_height = 600;
constexpr double margin = 0.06; ///< of the plan, free at each border
const Rgb lamp_color{1, 0.85, 0.2}, plane_color{0.3, 0.75, 1}, eye_color{1, 0.4, 0.3};

void paint(Image& image, int x, int y, const Rgb& color) {
    float* pixel = image.pixel(x, y);
    pixel[0] = static_cast<float>(color.r);
    pixel[1] = static_cast<float>(color.g);
    pixel[2] = static_cast<float>(color.b);
}

std::array<Vec3, 5> outline(const CPlane& plane) {
    const Vec3& o = plane.origin;
    return {o, o + plane.u, o + plane.u + plane.v, o + plane.v, o};
}

/// The camera above all contents of the plan.
Camera plan_camera(const Scene& scene, const PlaceResult& result) {
    Box3 box = scene.tracer.bounds();
    for (const PlacedPlane& plane : result.placement.planes)
        for (const Vec3& corner : outline(plane.lamps)) box.extend(corner);
    for (const NamedView& view : result.views) box.extend(view.camera.eye);
    const Vec3 middle = box.center(), extent = box.extent();
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.eye = {middle.x, middle.y, box.upper.z + 1};
    camera.target = {middle.x, middle.y, box.lower.z};
    camera.up = {0, 1, 0};
    camera.width = plan_width;
    camera.height = plan_height;
    camera.orthographic_height =
        std::max(extent.y, extent.x * plan_height / plan_width) / (1 - 2 * margin);
    return camera;
}

/// The body in grey, lighter where it is level.
Image body_from_above(const Tracer& tracer, const Camera& camera, const Job& job) {
    Image image(camera.width, camera.height, 3, 0.1F);
    parallel_for(static_cast<std::size_t>(camera.height), job, "plan", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::vector<Ray> rays;
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
        const auto hits = tracer.nearest(rays);
        for (int x = 0; x < camera.width; ++x)
            if (const auto& hit = hits[static_cast<std::size_t>(x)])
                paint(image, x, y, Rgb(0.2 + 0.45 * std::abs(hit->normal.z)));
    });
    return image;
}

void draw(Overlay& overlay, const Camera& camera, std::span<const Vec3> line, const Rgb& color) {
    Polyline drawn{.color = color};
    for (const Vec3& place : line)
        if (const auto pixel = project(camera, place)) drawn.points.push_back(*pixel);
    overlay.lines.push_back(std::move(drawn));
}

/// The weight that is reflected to each part of a plane, bright where it is large, with the lamps
/// and their rectangle: u to the right, v up.
Image histogram_picture(const PlacedPlane& plane) {
    const HitHistogram& h = plane.histogram;
    double most = 0;
    for (int v = 0; v < h.height(); ++v)
        for (int u = 0; u < h.width(); ++u) most = std::max(most, h.at(u, v));
    Image image(histogram_size, histogram_size, 3, 0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double weight = h.at(x * h.width() / image.width,
                                       (image.height - 1 - y) * h.height() / image.height);
            // The root shows the thin parts, which decide how far lamps must extend.
            if (weight > 0) paint(image, x, y, jet(std::sqrt(weight / most)));
        }
    const Vec2 scale = Vec2(image.width, image.height) / h.range().extent();
    const auto pixel = [&](const Vec3& place) {
        const Vec3 from = place - plane.lamps.origin;
        const Vec2 at(from.dot(plane.lamps.u.normalized()), from.dot(plane.lamps.v.normalized()));
        const Vec2 off = (at - h.range().lower) * scale;
        return Vec2(off.x, image.height - off.y);
    };
    Overlay overlay;
    for (const TubeLamp& lamp : lamps_of(plane.lamps))
        overlay.lines.push_back({{pixel(lamp.a), pixel(lamp.b)}, lamp_color, 1});
    Polyline border{.color = Rgb(1), .width = 2};
    for (const Vec3& corner : outline(plane.lamps)) border.points.push_back(pixel(corner));
    overlay.lines.push_back(std::move(border));
    return with_overlay(std::move(image), overlay);
}

/// Body, C-planes, lamps and cameras from above: x to the right, y up.
Image plan_picture(const Scene& scene, const PlaceResult& result, const Job& job) {
    const Camera camera = plan_camera(scene, result);
    Overlay overlay;
    for (const PlacedPlane& plane : result.placement.planes) {
        for (const TubeLamp& lamp : lamps_of(plane.lamps))
            draw(overlay, camera, std::array{lamp.a, lamp.b}, lamp_color);
        draw(overlay, camera, outline(plane.lamps), plane_color);
    }
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        const Camera& eye = result.views[i].camera;
        const std::array sight{eye.eye, eye.target};
        draw(overlay, camera, sight, eye_color);
        overlay.markers.push_back({*project(camera, eye.eye), std::to_string(i + 1), eye_color});
    }
    return with_overlay(body_from_above(scene.tracer, camera, job), overlay);
}

} // namespace

void write_placement(const std::filesystem::path& folder, const Scene& scene,
                     const PlaceResult& result, const Job& job) {
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) throw Error(folder.string(), "", "cannot make the folder: " + code.message());
    std::vector<std::string> views;
    for (const NamedView& view : result.views) views.push_back(view.name);
    write_text_file(folder / "placement.json",
                    placement_json(result.placement, scene.model, views, version()));
    for (std::size_t i = 0; i < result.placement.planes.size(); ++i)
        write_png(folder / ("histogram-" + std::to_string(i + 1) + ".png"),
                  histogram_picture(result.placement.planes[i]));
    write_png(folder / "plan.png", plan_picture(scene, result, job));
}

} // namespace keiko
