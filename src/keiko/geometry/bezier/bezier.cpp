#include "keiko/geometry/bezier/bezier.h"

#include <algorithm>
#include <cassert>

namespace keiko {
namespace {

/// h[k][l] = d^(k+l) (w S, w) / du^k dv^l for k + l <= order; the others are 0.
template <std::size_t order>
using HomogeneousDerivatives = std::array<std::array<Vec4, order + 1>, order + 1>;

/// The polynomials of a degree and their derivatives, at both parameters.
template <std::size_t order, std::size_t size>
using Basis = std::array<std::array<Vec2, size>, order + 1>;

/// Sums over the control points with the polynomials by u, the first components of `by_u`, and by
/// v, the second ones of `by_v`.
template <std::size_t order, std::size_t size>
HomogeneousDerivatives<order> homogeneous_derivatives(const BezierPatchView& patch,
                                                      const Basis<order, size>& by_u,
                                                      const Basis<order, size>& by_v) {
    const auto degree_u = static_cast<std::size_t>(patch.degree_u);
    const auto degree_v = static_cast<std::size_t>(patch.degree_v);
    HomogeneousDerivatives<order> result;
    for (auto& row : result) row.fill(Vec4(0));
    const Vec4* p = patch.points.data();
    for (std::size_t i = 0; i <= degree_u; ++i) {
        std::array<Vec4, order + 1> row;
        row.fill(Vec4(0));
        for (std::size_t j = 0; j <= degree_v; ++j, ++p)
            for (std::size_t l = 0; l <= order; ++l) row[l] += *p * by_v[l][j].y;
        for (std::size_t k = 0; k <= order; ++k)
            for (std::size_t l = 0; k + l <= order; ++l) result[k][l] += row[l] * by_u[k][i].x;
    }
    return result;
}

/// `size`: more than either degree.
template <std::size_t order, std::size_t size>
HomogeneousDerivatives<order> homogeneous_derivatives(const BezierPatchView& patch,
                                                      const Vec2& uv) {
    const auto degree_u = static_cast<std::size_t>(patch.degree_u);
    const auto degree_v = static_cast<std::size_t>(patch.degree_v);
    const Basis<order, size> by_u = bernstein_rows<order, size>(degree_u, uv);
    if (degree_u == degree_v) return homogeneous_derivatives<order, size>(patch, by_u, by_u);
    return homogeneous_derivatives<order, size>(patch, by_u,
                                                bernstein_rows<order, size>(degree_v, uv));
}

constexpr std::array<std::array<double, 4>, 4> binomial{
    {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};

/// S = A / w, hence d[k][l] A = sum of binomials times w derivatives times S derivatives. Constant
/// indices let loops be unrolled.
template <std::size_t k, std::size_t l, class Homogeneous>
[[gnu::always_inline]] inline void divide(const Homogeneous& h, SurfaceDerivatives& s) {
    Vec3 value(h[k][l].x, h[k][l].y, h[k][l].z);
    for (std::size_t i = 0; i <= k; ++i)
        for (std::size_t j = 0; j <= l; ++j)
            if (i + j > 0)
                value -= s.d[k - i][l - j] * (binomial[k][i] * binomial[l][j] * h[i][j].w);
    s.d[k][l] = value / h[0][0].w;
}

/// Degree of by far the most patches and curves.
constexpr int common = 7;

template <std::size_t order>
SurfaceDerivatives derivatives(const BezierPatchView& patch, const Vec2& uv) {
    const HomogeneousDerivatives<order> h =
        std::max(patch.degree_u, patch.degree_v) <= common
            ? homogeneous_derivatives<order, common + 1>(patch, uv)
            : homogeneous_derivatives<order, max_degree + 1>(patch, uv);
    SurfaceDerivatives result;
    divide<0, 0>(h, result);
    if constexpr (order > 0) divide<0, 1>(h, result), divide<1, 0>(h, result);
    if constexpr (order > 1)
        divide<0, 2>(h, result), divide<1, 1>(h, result), divide<2, 0>(h, result);
    if constexpr (order > 2)
        divide<0, 3>(h, result), divide<1, 2>(h, result), divide<2, 1>(h, result),
            divide<3, 0>(h, result);
    return result;
}

template <std::size_t order>
std::array<Vec2, 4> derivatives(const BezierCurveView& curve, double t) {
    const auto degree = static_cast<std::size_t>(curve.degree());
    const auto basis = bernstein_rows<order, max_degree + 1>(degree, Vec2(t));
    std::array<Vec3, order + 1> h;
    h.fill(Vec3(0));
    for (std::size_t k = 0; k <= order; ++k)
        for (std::size_t i = 0; i <= degree; ++i) h[k] += curve.points[i] * basis[k][i].x;
    std::array<Vec2, 4> result;
    result.fill(Vec2(0));
    for (std::size_t k = 0; k <= order; ++k) {
        Vec2 value(h[k].x, h[k].y);
        for (std::size_t i = 1; i <= k; ++i) value -= result[k - i] * (binomial[k][i] * h[i].z);
        result[k] = value / h[0].z;
    }
    return result;
}

} // namespace

std::array<Vec2, 4> evaluate(const BezierCurveView& curve, double t, int order) {
    assert(order >= 0 && order <= 3);
    switch (order) {
        case 0:
            return derivatives<0>(curve, t);
        case 1:
            return derivatives<1>(curve, t);
        case 2:
            return derivatives<2>(curve, t);
        default:
            return derivatives<3>(curve, t);
    }
}

Box2 hull_bounds(const BezierCurveView& curve) {
    Box2 box;
    for (const Vec3& p : curve.points) box.extend(Vec2(p.x, p.y) / p.z);
    return box;
}

bool BezierPatchView::rational() const {
    for (const Vec4& p : points)
        if (p.w != points.front().w) return true;
    return false;
}

SurfaceDerivatives evaluate(const BezierPatchView& patch, const Vec2& uv, int order) {
    assert(order >= 0 && order <= 3);
    switch (order) {
        case 0:
            return derivatives<0>(patch, uv);
        case 1:
            return derivatives<1>(patch, uv);
        case 2:
            return derivatives<2>(patch, uv);
        default:
            return derivatives<3>(patch, uv);
    }
}

Box3 hull_bounds(const BezierPatchView& patch) {
    Box3 box;
    for (const Vec4& p : patch.points) box.extend(euclidean(p));
    return box;
}

} // namespace keiko
