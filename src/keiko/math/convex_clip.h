#pragma once

#include "keiko/math/vec.h"

#include <cstddef>
#include <span>

namespace keiko {

/// Clips a convex polygon by a line [SutherlandHodgman1974]: calls `add`(corner) for the corners,
/// in order, of the part where a linear function is not negative. `value_of`(i) is its value at
/// corner i, and is called once.
template <class ValueOf, class Add>
void clip_convex(std::span<const Vec2> corners, const ValueOf& value_of, const Add& add) {
    if (corners.empty()) return;
    const double first = value_of(std::size_t{0});
    double from = first;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool closes = i + 1 == corners.size();
        const Vec2 &a = corners[i], &b = corners[closes ? 0 : i + 1];
        const double to = closes ? first : value_of(i + 1);
        if (from >= 0) add(a);
        if ((from >= 0) != (to >= 0)) add(a + (b - a) * (from / (from - to)));
        from = to;
    }
}

} // namespace keiko
