#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <cmath>
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

/// True if two segments, a to b and c to d, of a plane with this normal cross inside of both.
inline bool segments_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                           const Vec3& normal) {
    const auto side = [&](const Vec3& from, const Vec3& to, const Vec3& at) {
        return normal.dot((to - from).cross(at - from));
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Calls `visit(x)` where a side of a polygon crosses the line y, in the order of the sides. A
/// point (p, y) is inside by the even-odd rule if an odd number of them is beyond p.
template <class Visit>
void each_crossing(std::span<const Vec2> corners, double y, const Visit& visit) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
        if ((a.y > y) != (b.y > y)) visit(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
}

/// True for a point inside of a polygon, by the even-odd rule.
inline bool holds(std::span<const Vec2> corners, const Vec2& point) {
    bool inside = false;
    each_crossing(corners, point.y, [&](double x) { inside ^= point.x < x; });
    return inside;
}

} // namespace keiko
