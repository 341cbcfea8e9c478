#pragma once

#include "keiko/intersect/kernels/traced_ray.h"

#include <array>
#include <cstdint>

namespace keiko {

/// Set of lanes of a RayPacket, one bit each.
using LaneMask = std::uint32_t;

/// Up to 16 rays as the kernels read them: TracedRay, field for field.
struct alignas(64) RayPacket {
    static constexpr std::size_t capacity = 16;
    template <class T>
    using Lanes = std::array<T, capacity>;

    std::array<Lanes<double>, 3> start, direction;
    Lanes<double> low, high;
    Lanes<double> t_start, speed, error, slack;
    Lanes<double> blur; ///< mm: `error`, and rounding over any way within the scene, see ray_blur.h
    Lanes<const Ray*> rays;
    std::size_t count = 0;
    LaneMask active = 0; ///< rays that come near the scene
    /// Whether they go through the scene so much together that a packet shares most of its steps.
    bool coherent = false;

    double t_at(std::size_t lane, double s) const { return t_start[lane] + s / speed[lane]; }
    TracedRay ray(std::size_t lane) const {
        return {rays[lane],
                Vec3(start[0][lane], start[1][lane], start[2][lane]),
                Vec3(direction[0][lane], direction[1][lane], direction[2][lane]),
                t_start[lane],
                speed[lane],
                error[lane],
                low[lane],
                high[lane],
                slack[lane]};
    }
};

/// The ball around a scene.
struct SceneBall {
    Vec3 center{0};
    double radius = 0;
};

} // namespace keiko
