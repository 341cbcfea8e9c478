#include "tests/bench/panel_methods.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/area_penumbra.h"
#include "keiko/render/shading/occluded_visibility.h"

#include "tests/bench/cpu_clock.h"
#include "tests/support/random.h"

namespace keiko::bench {
namespace {

using namespace test;

constexpr int panels = 3;

/// Runs `lit(receiver, panel)` for all receivers and panels.
template <class Lit>
Shares shares(const PenumbraScene& scene, const std::vector<PolygonLight>& lights, const Lit& lit) {
    Shares all;
    all.seconds = thread_seconds([&] {
        for (const Receiver& at : scene.receivers) all.values.push_back(lit(at));
    });
    const double mean = mean_unhidden(scene, lights);
    for (double& value : all.values) value /= mean;
    return all;
}

/// Light of a stratum that a receiver sees, if the ray to it is free.
struct Sample {
    Ray ray;
    double light;
};

void add_samples(const PolygonLight& light, const Receiver& at, int side, Random& random,
                 std::vector<Sample>& samples) {
    const Vec3 along = light.corners[1] - light.corners[0];
    const Vec3 across = light.corners.back() - light.corners[0], normal = along.cross(across);
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const double u = (i + uniform(random, 0, 1)) / side;
            const double v = (k + uniform(random, 0, 1)) / side;
            const Vec3 x = light.corners[0] + along * u + across * v, way = x - at.position;
            const double cosine = at.normal.dot(way), facing = -normal.dot(way);
            if (!(cosine > 0 && facing > 0)) continue;
            const double squared = way.length2();
            samples.push_back({Viewpoint::at(at.position, at.root).ray_to(x),
                               cosine * facing / (squared * squared) / (side * side)});
        }
}

} // namespace

std::vector<PolygonLight> panels_behind(const PenumbraScene& scene) {
    const CPlane& row = scene.row;
    const double ground = scene.tracer.bounds().lower.z, height = row.origin.z - ground;
    const Vec3 up(0, 0, 0.4 * height), along = row.u / panels;
    std::vector<PolygonLight> lights;
    for (int i = 0; i < panels; ++i) {
        Vec3 corner = row.origin + row.v + along * (i + 0.1);
        corner.z = ground + 0.05 * height;
        const Vec3 side = along * 0.8;
        lights.push_back({{corner, corner + side, corner + side + up, corner + up}, Rgb(1)});
    }
    return lights;
}

double mean_unhidden(const PenumbraScene& scene, const std::vector<PolygonLight>& lights) {
    double whole = 0;
    for (const Receiver& at : scene.receivers)
        for (const PolygonLight& light : lights)
            whole += projected_solid_angle(light, at.position, at.normal);
    return whole / static_cast<double>(scene.receivers.size());
}

Shares by_lines(const PenumbraScene& scene, const std::vector<PolygonLight>& lights,
                double tolerance) {
    constexpr double spacing = 0.12; // as numbers have it
    return shares(scene, lights, [&](const Receiver& at) {
        double sum = 0;
        for (const PolygonLight& light : lights) {
            const double whole = projected_solid_angle(light, at.position, at.normal);
            if (!(whole > 0)) continue;
            const OccludedVisibility visible(&scene.occluders, scene.tracer,
                                             Viewpoint::at(at.position, at.root), light.corners, {},
                                             at.normal);
            sum += whole * visible_share(light, at.position, at.normal, visible,
                                         {tolerance, spacing, true});
        }
        return sum;
    });
}

Shares by_samples(const PenumbraScene& scene, const std::vector<PolygonLight>& lights, int side) {
    Random random(3);
    std::vector<Sample> samples;
    std::vector<Ray> rays;
    return shares(scene, lights, [&](const Receiver& at) {
        samples.clear(), rays.clear();
        for (const PolygonLight& light : lights) add_samples(light, at, side, random, samples);
        for (const Sample& sample : samples) rays.push_back(sample.ray);
        const std::vector<bool> hidden = scene.tracer.any(std::span<const Ray>(rays));
        double sum = 0;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (!hidden[i]) sum += samples[i].light;
        return sum;
    });
}

} // namespace keiko::bench
