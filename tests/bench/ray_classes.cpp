#include "tests/bench/ray_classes.h"

#include "keiko/placement/best_view.h"
#include "keiko/trace/mirror_ray.h"

#include <random>

namespace keiko::bench {
namespace {

std::vector<Ray> primary_rays(const SurfaceModel& model, const Tracer& tracer) {
    const Camera camera = best_view(tracer, model, {.width = 480, .height = 270}).camera;
    std::vector<Ray> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
    return rays;
}

std::vector<Ray> mirrored_rays(const Tracer& tracer, const std::vector<Ray>& primary) {
    std::vector<Ray> rays;
    for (const Ray& ray : primary)
        if (const auto hit = tracer.nearest(ray)) rays.push_back(mirror_ray(ray, *hit));
    return rays;
}

std::vector<Ray> random_rays(const Box3& box, std::size_t count) {
    std::mt19937_64 random(1990);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto inside = [&] {
        return box.lower + box.extent() * Vec3(unit(random), unit(random), unit(random));
    };
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const Vec3 a = inside(), b = inside();
        Ray ray;
        ray.direction = (b - a).normalized();
        ray.origin = a - ray.direction * (2 * box.size());
        rays.push_back(ray);
    }
    return rays;
}

} // namespace

std::vector<RayClass> ray_classes(const SurfaceModel& model, const Tracer& tracer) {
    std::vector<RayClass> classes;
    classes.push_back({"primary", primary_rays(model, tracer)});
    classes.push_back({"mirrored", mirrored_rays(tracer, classes.front().rays)});
    classes.push_back({"random", random_rays(tracer.bounds(), 100000)});
    return classes;
}

} // namespace keiko::bench
