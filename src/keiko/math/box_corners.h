#pragma once

#include "keiko/math/bounds.h"

#include <vector>

namespace keiko {

/// The eight corners of a box that is not empty.
inline std::vector<Vec3> corners_of(const Box3& box) {
    std::vector<Vec3> corners;
    for (const double x : {box.lower.x, box.upper.x})
        for (const double y : {box.lower.y, box.upper.y})
            for (const double z : {box.lower.z, box.upper.z}) corners.emplace_back(x, y, z);
    return corners;
}

} // namespace keiko
