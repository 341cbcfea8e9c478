#pragma once

#include "keiko/base/units.h"
#include "keiko/math/vec.h"

#include <cmath>

namespace keiko {

/// Radians: where a seam turns by more than this it has a corner, and another seam begins.
constexpr double seam_corner = degrees_to_radians(30);

/// Whether a line turns a corner where it runs on from one direction into another. False where one
/// of them is 0.
inline bool is_corner(const Vec3& before, const Vec3& after) {
    static const double cosine = std::cos(seam_corner);
    return before.dot(after) < cosine * before.length() * after.length();
}

} // namespace keiko
