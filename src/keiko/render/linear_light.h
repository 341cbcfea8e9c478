#pragma once

#include "keiko/math/vec.h"
#include "keiko/render/lit_spot.h"

#include <array>

namespace keiko {

/// Light at the corners of a rectangle, row by row, linear between them.
struct LinearLight {
    std::array<SpotLight, 4> corners{};

    /// `share`: of the way from left to right and from top to bottom, 0 to 1.
    SpotLight at(const Vec2& share) const {
        const auto [s, t] = std::array{share.x, share.y};
        return (corners[0] * (1 - s) + corners[1] * s) * (1 - t) +
               (corners[2] * (1 - s) + corners[3] * s) * t;
    }
};

} // namespace keiko
