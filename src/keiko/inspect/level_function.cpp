#include "keiko/inspect/level_function.h"

#include <cmath>

namespace keiko {
namespace {

Triple<double> triple(const Vec3& w) {
    return {w.x, w.y, w.z};
}

} // namespace

double LevelFunction::operator()(const Vec2& uv) const {
    const SurfaceDerivatives s = evaluate(patch_, uv, 1);
    return field_.ratio(triple(s.position()), triple(s.du().cross(s.dv())), level_).above;
}

Vec2 LevelFunction::root(Vec2 a, double at_a, Vec2 b, double at_b) const {
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

std::optional<LinePoint> LevelFunction::between(const LinePoint& a, const LinePoint& b,
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
