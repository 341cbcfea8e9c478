#pragma once

#include "keiko/math/vec.h"

namespace keiko {

/// Some vector across v, which must not be zero; of any length.
inline Vec3 any_perpendicular(const Vec3& v) {
    return v.cross(std::abs(v.x) < 0.7 * v.length() ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
}

} // namespace keiko
