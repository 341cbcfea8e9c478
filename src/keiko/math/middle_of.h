#pragma once

#include "keiko/math/vec.h"

#include <span>

namespace keiko {

/// The mean of points, of which there are some.
inline Vec3 middle_of(std::span<const Vec3> points) {
    Vec3 middle(0);
    for (const Vec3& point : points) middle += point / static_cast<double>(points.size());
    return middle;
}

} // namespace keiko
