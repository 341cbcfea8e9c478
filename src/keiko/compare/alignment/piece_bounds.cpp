#include "keiko/compare/alignment/piece_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Bounds of a numerator of a frame's coordinate, its first and its second derivatives.
struct Numerator {
    double value, slope, bend;

    /// Bound of the coordinate's second derivatives, by the quotient rule with the weight 1 + w.
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

PieceBounds::PieceBounds(const SubPatchFrame& f) {
    if (!f.regular) return;
    const auto& r = f.rows;
    const double determinant = r[0].dot(r[1].cross(r[2])), least = 1 - f.w.value;
    center_ = f.center;
    axes_ = {r[1].cross(r[2]) / determinant, r[2].cross(r[0]) / determinant,
             r[0].cross(r[1]) / determinant};
    const std::array<Numerator, 3> numerators{{{1 + f.u.value, 1 + f.u.slope, f.u.bend},
                                               {1 + f.v.value, 1 + f.v.slope, f.v.bend},
                                               {f.n.value, f.n.slope, f.n.bend}}};
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        second_[k] = numerators[k].second(f.w);
        value += axes_[k].length() * numerators[k].value;
        across_[k] = r[k].normalized();
        half_[k] = numerators[k].value / (least * r[k].length());
    }
    const double off = axes_[0].length() * f.u.slope + axes_[1].length() * f.v.slope +
                       axes_[2].length() * f.n.slope;
    first_ = (least_stretch(axes_[0], axes_[1]) - off) / (1 + f.w.value) -
             value * f.w.slope / (least * least);
}

double PieceBounds::nearest(const Vec3& p) const {
    double distance = 0;
    for (std::size_t k = 0; k < 3; ++k)
        distance = std::max(distance, std::abs(across_[k].dot(p - center_)) - half_[k]);
    return distance;
}

bool PieceBounds::proves(const Vec3& off) const {
    double bend = 0;
    for (std::size_t k = 0; k < 3; ++k) bend += std::abs(off.dot(axes_[k])) * second_[k];
    return first_ > 0 && bend <= first_ * first_;
}

} // namespace keiko
