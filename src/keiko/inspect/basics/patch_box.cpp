#include "keiko/inspect/basics/patch_box.h"

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

/// One row of control points cut at a share of its range.
void cut(std::vector<Vec4>& lower, std::vector<Vec4>& upper, double share) {
    const std::size_t n = lower.size();
    upper[n - 1] = lower[n - 1];
    for (std::size_t level = 1; level < n; ++level) {
        for (std::size_t i = n - 1; i >= level; --i)
            lower[i] = lower[i - 1] * (1 - share) + lower[i] * share;
        upper[n - 1 - level] = lower[n - 1];
    }
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
    const std::size_t count = by_u ? columns : rows, length = by_u ? rows : columns;
    std::vector<Vec4> first(points_.size()), second(points_.size());
    std::vector<Vec4> lower(length), upper(length);
    for (std::size_t line = 0; line < count; ++line) {
        const auto index = [&](std::size_t k) {
            return by_u ? k * columns + line : line * columns + k;
        };
        for (std::size_t k = 0; k < length; ++k) lower[k] = points_[index(k)];
        // cut() leaves the upper half in `upper` and turns `lower` into the last averages; the
        // lower half is the same cut from the other end.
        std::vector<Vec4> reversed(lower.rbegin(), lower.rend()), mirrored(length);
        cut(lower, upper, share);
        cut(reversed, mirrored, 1 - share);
        for (std::size_t k = 0; k < length; ++k) {
            first[index(k)] = mirrored[length - 1 - k];
            second[index(k)] = upper[k];
        }
    }
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
