#pragma once

#include "keiko/math/vec.h"

#include <cstdint>

namespace keiko {

/// A piece of a surface as wide as a pixel.
struct SurfaceFootprint {
    std::uint32_t instance = 0, face = 0; ///< of the surface, into the model's arrays
    Vec3 position{0};                     ///< its middle, mm
    Vec3 normal{0};                       ///< unit, on the side to be lit
    Vec3 dx{0}, dy{0};                    ///< sides of the parallelogram, mm, along the surface
};

} // namespace keiko
