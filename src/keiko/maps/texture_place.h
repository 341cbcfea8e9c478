#pragma once

#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// A place in texture coordinates, z = 0 on a projection, and the pixel around it.
struct TexturePlace {
    Vec3 at{0};        ///< the place
    Vec3 dx{0}, dy{0}; ///< its change by the pixel's two coordinates

    /// Width of the pixel along each coordinate.
    Vec3 widths() const { return magnitudes(dx) + magnitudes(dy); }
    /// Longer side of the pixel.
    double footprint() const { return std::sqrt(std::max(dx.length2(), dy.length2())); }
    /// The place moved by a step, with the same pixel.
    TexturePlace moved(const Vec3& step) const { return {at + step, dx, dy}; }
    /// The place and its pixel in other units.
    TexturePlace scaled(double factor) const { return {at * factor, dx * factor, dy * factor}; }
};

} // namespace keiko
