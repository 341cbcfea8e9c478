#include "keiko/inspect/basics/zero_function.h"

#include "keiko/base/job.h"

#include <cmath>

namespace keiko {

Vec2 ZeroFunction::root(Vec2 a, double at_a, Vec2 b, double at_b) const {
    check_stop();
    constexpr int secants = 30, most = 90;
    for (int i = 0; i < most; ++i) {
        const double share = i < secants ? at_a / (at_a - at_b) : 0.5;
        const Vec2 middle = a + (b - a) * share;
        const double value = (*this)(middle);
        if (value == 0 || middle == a || middle == b) return middle;
        if ((value < 0) == (at_a < 0)) {
            a = middle, at_a = value;
            if (i < secants) at_b /= 2;
        } else {
            b = a, at_b = at_a;
            a = middle, at_a = value;
        }
        if ((b - a).length() < 1e-16) break;
    }
    return std::abs(at_a) < std::abs(at_b) ? a : b;
}

std::optional<LinePoint> ZeroFunction::between(const LinePoint& a, const LinePoint& b,
                                               double share) const {
    const Vec2 chord = b.uv - a.uv, middle = a.uv + chord * share, across(-chord.y, chord.x);
    for (double reach = 1.0 / 64; reach <= 1; reach *= 2) {
        const Vec2 low = unit_square.nearest(middle - across * reach),
                   high = unit_square.nearest(middle + across * reach);
        const double at_low = (*this)(low), at_high = (*this)(high);
        if ((at_low < 0) != (at_high < 0)) return point(root(low, at_low, high, at_high));
    }
    return std::nullopt;
}

} // namespace keiko
