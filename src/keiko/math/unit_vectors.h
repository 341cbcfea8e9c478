#pragma once

#include "keiko/math/vec.h"

#include <cmath>

namespace keiko {

/// Unit vector as a place in the square [-1, 1]^2: its image on the octahedron, whose lower half is
/// folded outwards [Cigolle2014]. NaN for a vector without length.
inline Vec2 octahedral(const Vec3& unit) {
    const double size = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
    const Vec2 upper(unit.x / size, unit.y / size);
    if (!(unit.z < 0)) return upper;
    return {std::copysign(1 - std::abs(upper.y), upper.x),
            std::copysign(1 - std::abs(upper.x), upper.y)};
}

/// Unit vector at a place in the square: the inverse of octahedral().
inline Vec3 from_octahedral(const Vec2& place) {
    const double height = 1 - std::abs(place.x) - std::abs(place.y);
    if (height >= 0) return Vec3(place.x, place.y, height).normalized();
    return Vec3(std::copysign(1 - std::abs(place.y), place.x),
                std::copysign(1 - std::abs(place.x), place.y), height)
        .normalized();
}

/// Unit axes across a direction; x, y and the direction are right-handed.
struct AxesAcross {
    Vec3 x, y; ///< square to the direction and to each other

    /// Axes across a unit vector [Duff2017]. `side`: 1 or -1, the sign of its z; if that is close
    /// to 0, either.
    AxesAcross(const Vec3& unit, double side) {
        const double a = -1 / (side + unit.z), b = unit.x * unit.y * a;
        x = {1 + side * unit.x * unit.x * a, side * b, -side * unit.x};
        y = {b, side + unit.y * unit.y * a, -unit.y};
    }
};

} // namespace keiko
