#include "tests/bench/ray_classes.h"

#include "keiko/intersect/hit/reflect_ray.h"
#include "keiko/placement/best_view.h"

#include "tests/bench/grazing_rays.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace keiko::bench {
namespace {

constexpr int block = 4; ///< pixels: 4 x 4 neighbours make a packet of 16

void find_truth(RaySet& set, const Tracer& tracer) {
    set.truth.reserve(set.rays.size());
    for (const Ray& ray : set.rays) set.truth.push_back(tracer.nearest(ray));
}

int in_blocks(double pixels) {
    return block * std::max(1, static_cast<int>(std::lround(pixels / block)));
}

} // namespace

Camera bench_camera(const SurfaceModel& model, const Tracer& tracer, std::size_t rays) {
    const double height = std::sqrt(static_cast<double>(rays) * 9 / 16);
    const Framing framing{.width = in_blocks(height * 16 / 9), .height = in_blocks(height)};
    return best_view(tracer, model, framing, {.threads = 1}).camera;
}

RaySet primary_rays(const Camera& camera, const Tracer& tracer) {
    RaySet set{.name = "primary", .coherent = true};
    const double in_full_hd = camera.height / 1080.0;
    for (int y0 = 0; y0 < camera.height; y0 += block)
        for (int x0 = 0; x0 < camera.width; x0 += block)
            for (int i = 0; i < block * block; ++i) {
                Ray ray = camera.ray(x0 + i % block + 0.5, y0 + i / block + 0.5);
                ray.differentials = ray.differentials->scaled(in_full_hd);
                set.rays.push_back(ray);
            }
    find_truth(set, tracer);
    return set;
}

RaySet mirrored_rays(const RaySet& primary, const Tracer& tracer) {
    RaySet set{.name = "mirrored", .coherent = true};
    for (std::size_t i = 0; i < primary.rays.size(); ++i) {
        if (!primary.truth[i]) continue;
        set.rays.push_back(reflect_ray(primary.rays[i], *primary.truth[i]));
        set.leaving_sine.push_back(
            std::abs(set.rays.back().direction.dot(primary.truth[i]->normal)));
    }
    find_truth(set, tracer);
    return set;
}

RaySet random_rays(const Tracer& tracer, std::size_t count) {
    const Box3& box = tracer.bounds();
    std::mt19937_64 random(1990);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto inside = [&] {
        const double x = unit(random), y = unit(random), z = unit(random);
        return box.lower + box.extent() * Vec3(x, y, z);
    };
    RaySet set{.name = "random"};
    while (set.rays.size() < count) {
        const Vec3 a = inside(), b = inside();
        if (!((b - a).length() > 1e-3 * box.size())) continue;
        Ray ray;
        ray.direction = (b - a).normalized();
        ray.origin = a - ray.direction * (2 * box.size());
        set.rays.push_back(ray);
    }
    find_truth(set, tracer);
    return set;
}

std::vector<RaySet> ray_classes(const SurfaceModel& model, const Tracer& tracer,
                                std::size_t count) {
    std::vector<RaySet> classes;
    classes.push_back(primary_rays(bench_camera(model, tracer, count), tracer));
    classes.push_back(mirrored_rays(classes.front(), tracer));
    classes.push_back(random_rays(tracer, count));
    classes.push_back(grazing_rays(model, tracer.bounds(), count));
    find_truth(classes.back(), tracer);
    return classes;
}

} // namespace keiko::bench
