#include "keiko/inspect/structure/curve_length.h"

#include <array>

namespace keiko {
namespace {

double polygon_length(const CurvePoints& curve) {
    double length = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (euclidean(curve[i]) - euclidean(curve[i - 1])).length();
    return length;
}

/// De Casteljau's algorithm at 1/2: the two halves.
std::array<CurvePoints, 2> halves(CurvePoints curve) {
    CurvePoints left, right(curve.size());
    for (std::size_t last = curve.size(); last-- > 0;) {
        left.push_back(curve.front());
        right[last] = curve[last];
        for (std::size_t i = 0; i < last; ++i) curve[i] = (curve[i] + curve[i + 1]) * 0.5;
    }
    return {std::move(left), std::move(right)};
}

LengthRange range_of(const CurvePoints& curve, int halvings) {
    constexpr double precision = 1e-6; // of the length: far finer than any limit of it
    const LengthRange whole{chord_length(curve), polygon_length(curve)};
    if (halvings == 0 || !(whole.most - whole.least > precision * whole.most)) return whole;
    const auto [left, right] = halves(curve);
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
    return euclidean(halves(curve)[1].front());
}

} // namespace keiko
