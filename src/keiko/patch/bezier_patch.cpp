#include "keiko/patch/bezier_patch.h"

#include <cassert>

namespace keiko {
namespace {

using HomogeneousDerivatives = std::array<std::array<Vec4, 4>, 4>;

// Imath's vectors start undefined, even in a braced array.
std::array<Vec4, 4> zero_row() {
    std::array<Vec4, 4> row{};
    row.fill(Vec4(0));
    return row;
}

HomogeneousDerivatives homogeneous_derivatives(const BezierPatchView& patch, const Vec2& uv,
                                               int order) {
    const auto bu = bernstein_derivatives(patch.degree_u, uv.x, std::min(order, patch.degree_u));
    const auto bv = bernstein_derivatives(patch.degree_v, uv.y, std::min(order, patch.degree_v));
    HomogeneousDerivatives result{};
    result.fill(zero_row());
    for (std::size_t i = 0; i <= static_cast<std::size_t>(patch.degree_u); ++i) {
        std::array<Vec4, 4> row = zero_row();
        for (std::size_t j = 0; j <= static_cast<std::size_t>(patch.degree_v); ++j) {
            const Vec4& p = patch.point(static_cast<int>(i), static_cast<int>(j));
            for (std::size_t l = 0; l <= static_cast<std::size_t>(order); ++l)
                row[l] += p * bv[l][j];
        }
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k)
            for (std::size_t l = 0; k + l <= static_cast<std::size_t>(order); ++l)
                result[k][l] += row[l] * bu[k][i];
    }
    return result;
}

constexpr std::array<std::array<double, 4>, 4> binomial{
    {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};

/// S = A / w, hence d[k][l] A = sum of binomials times w derivatives times S derivatives.
Vec3 quotient(const HomogeneousDerivatives& h, const SurfaceDerivatives& known, std::size_t k,
              std::size_t l) {
    Vec3 value(h[k][l].x, h[k][l].y, h[k][l].z);
    for (std::size_t i = 0; i <= k; ++i)
        for (std::size_t j = 0; j <= l; ++j)
            if (i + j > 0)
                value -= known.d[k - i][l - j] * (binomial[k][i] * binomial[l][j] * h[i][j].w);
    return value / h[0][0].w;
}

} // namespace

bool BezierPatchView::rational() const {
    for (const Vec4& p : points)
        if (p.w != points.front().w) return true;
    return false;
}

SurfaceDerivatives evaluate(const BezierPatchView& patch, const Vec2& uv, int order) {
    assert(order >= 0 && order <= 3);
    const HomogeneousDerivatives h = homogeneous_derivatives(patch, uv, order);
    SurfaceDerivatives result;
    for (std::size_t total = 0; total <= static_cast<std::size_t>(order); ++total)
        for (std::size_t k = 0; k <= total; ++k)
            result.d[k][total - k] = quotient(h, result, k, total - k);
    return result;
}

Box3 hull_bounds(const BezierPatchView& patch) {
    Box3 box;
    for (const Vec4& p : patch.points) box.extend(Vec3(p.x, p.y, p.z) / p.w);
    return box;
}

} // namespace keiko
