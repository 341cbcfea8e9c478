#include "tests/bench/trimming_cost.h"

#include "keiko/intersect/traversal/tracer.h"

#include "tests/bench/cpu_clock.h"
#include "tests/bench/summary.h"
#include "tests/support/model_builder.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace keiko::bench {
namespace {

constexpr int curves = 100;
constexpr double size = 1000; ///< mm

/// A place of the loop, and how it moves on: a wavy ring in the patch's [0, 1]^2.
struct Place {
    Vec2 at, along;
};

Place on_ring(double angle) {
    constexpr double waves = 9, height = 0.05;
    const double r = 0.42 * (1 + height * std::sin(waves * angle));
    const double slope = 0.42 * height * waves * std::cos(waves * angle);
    const Vec2 out(std::cos(angle), std::sin(angle)), round(-out.y, out.x);
    return {Vec2(0.5) + out * r, out * slope + round * r};
}

/// The ring in cubic pieces, by Hermite's interpolation.
std::vector<std::vector<Vec3>> ring() {
    std::vector<std::vector<Vec3>> loop;
    constexpr double step = 2 * std::numbers::pi / curves;
    for (int i = 0; i < curves; ++i) {
        const Place a = on_ring(step * i), b = on_ring(i + 1 == curves ? 0 : step * (i + 1));
        std::vector<Vec3> points;
        for (const Vec2& p : {a.at, a.at + a.along * (step / 3), b.at - b.along * (step / 3), b.at})
            points.emplace_back(p.x, p.y, 1);
        loop.push_back(std::move(points));
    }
    return loop;
}

/// A bicubic patch bent like a bonnet.
test::ModelBuilder bonnet() {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const double x = i / 3.0, y = j / 3.0;
            points.emplace_back(size * x, size * y, 0.3 * size * (x * (1 - x) + y * (1 - y) * x));
        }
    test::ModelBuilder builder;
    builder.patch(3, 3, points);
    return builder;
}

/// A picture of the patch, in blocks of 4 x 4 pixels; only rays with a hit on both.
std::vector<Ray> rays_at(const Tracer& a, const Tracer& b) {
    constexpr int blocks = 64;
    std::vector<Ray> rays;
    const Vec3 eye(0.4 * size, 0.3 * size, 3 * size);
    for (int block = 0; block < blocks * blocks; ++block)
        for (int pixel = 0; pixel < 16; ++pixel) {
            const double x = 4.0 * (block % blocks) + pixel % 4 + 0.5;
            const double y = 4.0 * (block / blocks) + pixel / 4 + 0.5;
            Ray ray;
            ray.origin = eye;
            ray.direction = (Vec3(x, y, 0) * (size / (4 * blocks)) - eye).normalized();
            if (a.any(ray) && b.any(ray)) rays.push_back(ray);
        }
    return rays;
}

} // namespace

double trimming_cost(int rounds) {
    test::ModelBuilder builder = bonnet();
    const Tracer whole(builder.build());
    builder.loop(ring());
    const Tracer trimmed(builder.build());
    const std::vector<Ray> rays = rays_at(whole, trimmed);
    std::vector<double> costs;
    for (int round = 0; round < rounds; ++round) {
        const double without = thread_seconds([&] { whole.nearest_crossings(rays); });
        const double with = thread_seconds([&] { trimmed.nearest_crossings(rays); });
        costs.push_back(with / without - 1);
    }
    return median(std::move(costs));
}

} // namespace keiko::bench
