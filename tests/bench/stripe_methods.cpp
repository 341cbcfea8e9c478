#include "tests/bench/stripe_methods.h"

#include "keiko/film/tone_mapping.h"
#include "keiko/render/shading/integrator.h"
#include "keiko/render/tiles.h"

#include <cmath>

namespace keiko::bench {
namespace {

const Job one_thread{.progress = {}, .stop = {}, .threads = 1};

/// Level, over the body and far beyond it on all sides: half of what is mirrored upwards is lamps.
CPlane lamps_over(const Box3& box) {
    constexpr double reach = 8; // sizes of the body
    constexpr int lamps = 80;
    const double edge = reach * box.size();
    const Vec3 middle = box.center();
    return {.origin = {middle.x - edge / 2, middle.y - edge / 2, box.upper.z + box.size()},
            .u = {edge, 0, 0},
            .v = {0, edge, 0},
            .lamps = lamps,
            .diameter = edge / lamps / 2};
}

Image shown(const Film& film, double white) {
    return tone_mapped(film, {.ev = std::log2(white / saturation_luminance(0))});
}

} // namespace

StripeScene::StripeScene(std::string scene, const SurfaceModel& body, const Camera& from)
    : name(std::move(scene)),
      tracer(body, {.second_derivatives = true}),
      materials(body.faces.size()),
      camera(from) {
    for (Material& material : materials) material.diffuse = Rgb(0);
    rig.sources = {lamps_over(tracer.bounds())};
    rig.ambient = Rgb(300);
}

Film with_footprints(const StripeScene& scene, int edge_samples) {
    return render(scene.picture(), scene.camera, {.aovs = {}, .edge_samples = edge_samples},
                  one_thread);
}

Film supersampled(const StripeScene& scene, int n, bool footprints) {
    const Camera& camera = scene.camera;
    const PictureScene picture = scene.picture();
    const PictureOptions options{.aovs = {}, .edge_samples = 1};
    const Integrator integrator(picture, options);
    Film film = blank_film(camera.width, camera.height, {});
    const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    const std::vector<double> shares(cells, 1);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            std::vector<Ray> rays;
            rays.reserve(cells);
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    Ray ray = camera.ray(x + (i + 0.5) / n, y + (j + 0.5) / n);
                    if (footprints)
                        ray.differentials = ray.differentials->scaled(1.0 / n);
                    else
                        ray.differentials.reset();
                    rays.push_back(ray);
                }
            write_mean(film, x, y, integrator.follow(rays).samples, shares);
        }
    return film;
}

double display_rms(const Film& picture, const Film& truth, const std::vector<bool>& chosen) {
    const double white = white_luminance(truth);
    const Image a = shown(picture, white), b = shown(truth, white);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        if (!chosen[i / 3]) continue;
        const double off = static_cast<double>(a.values[i] - b.values[i]);
        sum += off * off;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

std::vector<bool> same_pixels(const Film& a, const Film& b) {
    std::vector<bool> same;
    for (std::size_t i = 0; i < a.color.values.size(); i += 3)
        same.push_back(std::equal(&a.color.values[i], &a.color.values[i] + 3, &b.color.values[i]));
    return same;
}

} // namespace keiko::bench
