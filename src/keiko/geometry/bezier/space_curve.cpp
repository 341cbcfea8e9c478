#include "keiko/geometry/bezier/space_curve.h"

#include "keiko/geometry/bernstein/de_casteljau.h"

namespace keiko {
namespace {

double polygon_length(const CurvePoints& curve) {
    double length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (euclidean(curve[i]) - euclidean(curve[i - 1])).length();
    return length;
}

LengthRange range_of(const CurvePoints& curve, int halvings) {
    constexpr double precision = 1e-6; // of the length: far finer than any limit of it
    const LengthRange whole{chord_length(curve), polygon_length(curve)};
    if (halvings == 0 || !(whole.most - whole.least > precision * whole.most)) return whole;
    const auto [left, right] = bernstein_parts(curve);
    const LengthRange a = range_of(left, halvings - 1), b = range_of(right, halvings - 1);
    return {a.least + b.least, a.most + b.most};
}

} // namespace

double chord_length(const CurvePoints& curve) {
    return (euclidean(curve.back()) - euclidean(curve.front())).length();
}

LengthRange curve_length(const CurvePoints& curve) {
    constexpr int most_halvings = 10;
    return range_of(curve, most_halvings);
}

Vec3 curve_middle(const CurvePoints& curve) {
    return euclidean(bernstein_value(curve, 0.5));
}

} // namespace keiko
