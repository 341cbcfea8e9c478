#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <cstddef>
#include <span>

namespace KEIKO_API keiko {

/// Normal of a plane polygon, twice its area long [Sutherland1974]. Viewed from the side that it
/// points to, the corners run anticlockwise. Requires a corner.
inline Vec3 polygon_normal(std::span<const Vec3> corners) {
    Vec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return sum;
}

} // namespace keiko
