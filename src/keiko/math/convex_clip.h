#pragma once

#include <cstddef>

namespace keiko {

/// Clips a convex polygon by a line, or by a plane in space [SutherlandHodgman1974]: calls
/// `add`(corner) for the corners, in order, of the part where a linear function is not negative.
/// `corners` is a container of vectors. `value_of`(i) is the value at corner i, and is called once.
template <class Corners, class ValueOf, class Add>
void clip_convex(const Corners& corners, const ValueOf& value_of, const Add& add) {
    if (corners.empty()) return;
    const double first = value_of(std::size_t{0});
    double from = first;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool closes = i + 1 == corners.size();
        const auto &a = corners[i], &b = corners[closes ? 0 : i + 1];
        const double to = closes ? first : value_of(i + 1);
        if (from >= 0) add(a);
        if ((from >= 0) != (to >= 0)) add(a + (b - a) * (from / (from - to)));
        from = to;
    }
}

} // namespace keiko
