#pragma once

#include "keiko/math/bounds.h"

namespace keiko {

/// Height of places along a direction, mm: a linear function of them.
struct Height {
    Vec3 slope{0};
    double offset = 0;

    double of(const Vec3& place) const { return slope.dot(place) + offset; }
    /// The largest height in the box; -infinity for an empty one.
    double most(const Box3& box) const {
        if (box.empty()) return -Box3::infinity;
        double sum = offset;
        for (unsigned k = 0; k < 3; ++k)
            sum += std::max(slope[k] * box.lower[k], slope[k] * box.upper[k]);
        return sum;
    }
};

} // namespace keiko
