#pragma once

#include "keiko/patch/ray.h"

#include <array>
#include <cstdint>

namespace keiko {

/// Set of lanes of a RayBlock, one bit each.
using LaneMask = std::uint32_t;

/// Up to 16 rays as the kernels read them. Distances s are in mm along the unit direction from
/// `start`.
struct alignas(64) RayBlock {
    static constexpr std::size_t capacity = 16;
    template <class T>
    using Lanes = std::array<T, capacity>;

    std::array<Lanes<double>, 3> start, direction; ///< world
    Lanes<double> low, high;                       ///< range of s still of interest
    Lanes<double> blur;                            ///< mm, see ray_blur
    std::size_t count = 0;
};

} // namespace keiko
