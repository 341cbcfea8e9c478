#pragma once

#include "keiko/math/bounds.h"

#include <algorithm>
#include <span>

namespace keiko {

/// Distance from a place beyond which there is none of some boxes; 0 without any.
inline double reach_from(const Vec3& place, std::span<const Box3> boxes) {
    double reach = 0;
    for (const Box3& box : boxes)
        reach = std::max(reach, (box.center() - place).length() + box.size());
    return reach;
}

} // namespace keiko
