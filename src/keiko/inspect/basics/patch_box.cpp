#include "keiko/inspect/basics/patch_box.h"

#include "keiko/geometry/bernstein/coefficient_lines.h"

#include <algorithm>

namespace keiko {
namespace {

/// Rounding error of de Casteljau's averages, as a share of the largest coordinate. Each of some 30
/// halvings of degree up to 25 adds less than one unit in the last place to the mean of its
/// numbers.
constexpr double relative_rounding = 1e-14;

double largest(const std::vector<Vec4>& points, int axis) {
    double size = 0;
    for (const Vec4& p : points) size = std::max(size, std::abs(p[axis]));
    return size;
}

} // namespace

PatchBox::PatchBox(const BezierPatchView& patch)
    : degree_u_(patch.degree_u),
      degree_v_(patch.degree_v),
      uv_(unit_square),
      points_(patch.points.begin(), patch.points.end()) {}

std::array<PatchBox, 2> PatchBox::parts(bool by_u, double share) const {
    const auto rows = static_cast<std::size_t>(degree_u_) + 1;
    const auto columns = static_cast<std::size_t>(degree_v_) + 1;
    std::vector<Vec4> first = points_, second = points_;
    split_lines(second.data(), first.data(), CoefficientLines::of_tensor(rows, columns, by_u),
                share);
    const Vec2 at = uv_.lower + uv_.extent() * share;
    Box2 low = uv_, high = uv_;
    (by_u ? low.upper.x : low.upper.y) = by_u ? at.x : at.y;
    (by_u ? high.lower.x : high.lower.y) = by_u ? at.x : at.y;
    return {PatchBox(degree_u_, degree_v_, low, std::move(first)),
            PatchBox(degree_u_, degree_v_, high, std::move(second))};
}

double PatchBox::rounding() const {
    return relative_rounding *
           std::max({largest(points_, 0), largest(points_, 1), largest(points_, 2)});
}

std::array<double, 2> net_extents(const BezierPatchView& patch) {
    const auto at = [&](int i, int j) { return euclidean(patch.point(i, j)); };
    std::array<double, 2> most{};
    for (int i = 0; i <= patch.degree_u; ++i)
        for (int j = 0; j <= patch.degree_v; ++j) {
            if (i > 0)
                most[0] = std::max(most[0], (at(i, j) - at(i - 1, j)).length() * patch.degree_u);
            if (j > 0)
                most[1] = std::max(most[1], (at(i, j) - at(i, j - 1)).length() * patch.degree_v);
        }
    return most;
}

} // namespace keiko
