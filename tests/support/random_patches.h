#pragma once

#include "keiko/geometry/rays/ray.h"

#include "tests/support/random.h"
#include "tests/support/shapes.h"

#include <cmath>

namespace keiko::test {

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
