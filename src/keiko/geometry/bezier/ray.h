#pragma once

#include "keiko/base/memory.h"
#include "keiko/math/bounds.h"
#include "keiko/math/ray_differentials.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace keiko {

/// A place on a surface in which a hit was proved to lie: a box of patch parameters. Secondary rays
/// exclude the root they start from by it, not by an offset along the ray.
struct Root {
    std::uint32_t instance = 0, patch = 0;
    Box2 uv;
};

/// A ray in world coordinates, mm. `direction` need not be unit; t counts in its lengths.
struct Ray {
    Vec3 origin{0}, direction{0, 0, 1};
    double t_min = 0;
    double t_max = std::numeric_limits<double>::infinity();
    std::optional<RayDifferentials> differentials{};
    /// Root excluded from the hits. It must be a root of this very ray, at t = 0 or at t_max: its
    /// start or its end.
    std::optional<Root> excluded{};

    Vec3 at(double t) const { return origin + direction * t; }
};

/// Array of rays, not initialised when resized.
using Rays = std::vector<Ray, DefaultInitAllocator<Ray>>;

} // namespace keiko
