#include "keiko/compare/alignment/convexity.h"

#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Bounds of a numerator of a frame's coordinate, its first and its second derivatives.
struct Numerator {
    double value, slope, bend;

    /// Of the coordinate's second derivatives, by the quotient rule with the weight 1 + w.
    double second(const ComponentBounds& w) const {
        const double least = 1 - w.value;
        return (bend + (2 * slope * w.slope + value * w.bend) / least +
                2 * value * w.slope * w.slope / (least * least)) /
               least;
    }
};

/// Least length of a x + b y over the unit circle.
double least_stretch(const Vec3& a, const Vec3& b) {
    const double uu = a.length2(), vv = b.length2(), uv = a.dot(b);
    return std::sqrt(std::max(0.0, (uu + vv) / 2 - std::hypot((uu - vv) / 2, uv)));
}

} // namespace

Convexity::Convexity(const BezierPatchView& piece) {
    const SubPatchFrame f = sub_patch_frame(piece);
    if (!f.regular) return;
    const auto& r = f.rows;
    const double determinant = r[0].dot(r[1].cross(r[2]));
    axes_ = {r[1].cross(r[2]) / determinant, r[2].cross(r[0]) / determinant,
             r[0].cross(r[1]) / determinant};
    const std::array<Numerator, 3> numerators{{{1 + f.u.value, 1 + f.u.slope, f.u.bend},
                                               {1 + f.v.value, 1 + f.v.slope, f.v.bend},
                                               {f.n.value, f.n.slope, f.n.bend}}};
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        second_[k] = numerators[k].second(f.w);
        value += axes_[k].length() * numerators[k].value;
    }
    const double off = axes_[0].length() * f.u.slope + axes_[1].length() * f.v.slope +
                       axes_[2].length() * f.n.slope;
    const double least = 1 - f.w.value;
    first_ = (least_stretch(axes_[0], axes_[1]) - off) / (1 + f.w.value) -
             value * f.w.slope / (least * least);
}

bool Convexity::holds(const BezierPatchView& piece, const Vec3& p) const {
    if (!(first_ > 0)) return false;
    std::array<double, 3> reach{};
    for (const Vec4& point : piece.points) {
        const Vec3 off = Vec3(point.x, point.y, point.z) / point.w - p;
        for (std::size_t k = 0; k < 3; ++k)
            reach[k] = std::max(reach[k], std::abs(off.dot(axes_[k])));
    }
    return first_ * first_ > reach[0] * second_[0] + reach[1] * second_[1] + reach[2] * second_[2];
}

} // namespace keiko
