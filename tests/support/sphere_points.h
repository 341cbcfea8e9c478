#pragma once

#include "keiko/raster/light_cone.h"
#include "keiko/raster/mesh_shadows.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace keiko::test {

/// Points that stand for equal parts of a sphere, along a spiral.
inline std::vector<EmittingPoint> points_of(const LightSphere& sphere, int count) {
    std::vector<EmittingPoint> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, flat = std::sqrt(1 - z * z);
        const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const Vec3 normal(flat * std::cos(turn), flat * std::sin(turn), z);
        points.push_back({sphere.center + normal * sphere.radius, normal, 1});
    }
    return points;
}

} // namespace keiko::test
