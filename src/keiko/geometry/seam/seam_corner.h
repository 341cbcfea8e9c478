#pragma once

#include "keiko/base/units.h"
#include "keiko/math/vec.h"

#include <cmath>

namespace keiko {

/// Radians: a seam that turns by more than this has a corner, where another seam begins.
constexpr double seam_corner = degrees_to_radians(30);

/// True if a line that changes from one direction to another turns a corner; false if one of them
/// is 0.
inline bool is_corner(const Vec3& before, const Vec3& after) {
    static const double cosine = std::cos(seam_corner);
    return before.dot(after) < cosine * before.length() * after.length();
}

} // namespace keiko
