#pragma once

#include "keiko/geometry/visibility/viewpoint.h"

#include <span>
#include <vector>

namespace keiko {

/// Corners of the part of a convex body on the side of the plane through a viewpoint that the unit
/// normal `facing` looks at, and maybe places between them.
inline std::vector<Vec3> clip_to_half_space(const Viewpoint& viewpoint, const Vec3& facing,
                                            std::span<const Vec3> corners) {
    std::vector<Vec3> part;
    part.reserve(2 * corners.size());
    for (const Vec3& p : corners) {
        const double at_p = facing.dot(viewpoint.way_to(p));
        if (at_p >= 0) part.push_back(p);
        for (const Vec3& q : corners) {
            const double at_q = facing.dot(viewpoint.way_to(q));
            if (at_p > 0 && at_q < 0) part.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
    }
    return part;
}

} // namespace keiko
