#pragma once

#include "tests/support/random.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace keiko::test {

/// Diffuse surface that a path meets.
struct DiffuseHit {
    Vec3 position, normal; ///< unit, on the side that the path comes from
    Vec3 reflectance;
};

/// A scene of diffuse surfaces for a path tracer.
struct DiffuseScene {
    std::function<std::optional<DiffuseHit>(const Vec3& origin, const Vec3& direction)> hit;
    /// Direct light of the lamps, lx, at a point, of one random sample of each lamp.
    std::function<Vec3(const Vec3& point, const Vec3& normal, Random&)> direct;
};

/// A mean of independent samples with its standard error.
struct Estimate {
    Vec3 mean{0}, error{0};
};

/// A direction by the cosine about a normal.
inline Vec3 cosine_direction(const Vec3& normal, Random& random) {
    for (;;) {
        const Vec3 way = normal + random_direction(random);
        if (way.length2() > 1e-12) return way.normalized();
    }
}

/// Illuminance in lx of a point by light that surfaces have reflected at least once: the mean of
/// `paths` paths of the cosine's density, each with the direct light at all of its corners
/// [Kajiya1986]. It ends at random by the largest reflectance.
inline Estimate reflected_light(const DiffuseScene& scene, const Vec3& point, const Vec3& normal,
                                int paths, Random& random) {
    Vec3 sum(0), squares(0);
    for (int path = 0; path < paths; ++path) {
        Vec3 light(0), weight(1), from = point, up = normal;
        while (const auto hit = scene.hit(from, cosine_direction(up, random))) {
            weight *= hit->reflectance;
            light += weight * scene.direct(hit->position, hit->normal, random);
            const double goes_on =
                std::max({hit->reflectance.x, hit->reflectance.y, hit->reflectance.z});
            if (uniform(random, 0, 1) >= goes_on) break;
            weight /= goes_on;
            from = hit->position, up = hit->normal;
        }
        sum += light, squares += light * light;
    }
    const Vec3 mean = sum / paths, variance = squares / paths - mean * mean;
    const auto root = [&](double v) { return std::sqrt(std::max(v, 0.0) / paths); };
    return {mean, Vec3(root(variance.x), root(variance.y), root(variance.z))};
}

} // namespace keiko::test
