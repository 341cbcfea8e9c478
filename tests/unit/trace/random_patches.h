#pragma once

#include "keiko/patch/ray.h"

#include "tests/unit/trace/shapes.h"

#include <cmath>
#include <random>

namespace keiko::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
}

inline Vec3 random_direction(Random& random) {
    for (;;) {
        const Vec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        if (v.length2() > 0.01 && v.length2() < 1) return v.normalized();
    }
}

inline Ray ray_through(const Vec3& origin, const Vec3& direction, double t_min = 0,
                       double t_max = std::numeric_limits<double>::infinity()) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.t_min = t_min;
    ray.t_max = t_max;
    return ray;
}

inline Ray excluding(const Root& root, Ray ray) {
    ray.excluded = root;
    return ray;
}

/// A wavy sheet about the square [-50, 50]^2: `rough` mm of noise on the control points, weights
/// up to a factor `weights` apart (1: not rational).
inline PatchData random_patch(Random& random, int degree_u, int degree_v, double rough,
                              double weights, const Vec3& offset = Vec3(0)) {
    PatchData patch{degree_u, degree_v, {}, {}, {}};
    for (int i = 0; i <= degree_u; ++i)
        for (int j = 0; j <= degree_v; ++j) {
            const double w = std::exp(uniform(random, -0.5, 0.5) * std::log(weights));
            const Vec3 noise(uniform(random, -rough, rough), uniform(random, -rough, rough),
                             uniform(random, -rough, rough));
            const Vec3 p =
                Vec3(100.0 * i / degree_u - 50, 100.0 * j / degree_v - 50, 0) + noise + offset;
            patch.points.emplace_back(p.x * w, p.y * w, p.z * w, w);
        }
    return patch;
}

} // namespace keiko::test
