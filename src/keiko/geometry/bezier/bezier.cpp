#include "keiko/geometry/bezier/bezier.h"

#include <algorithm>
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

/// The polynomials of the degrees that most patches have, unrolled.
template <std::size_t order, std::size_t size>
std::array<std::array<double, size>, 4> rows_of(std::size_t degree, double t) {
    switch (degree) {
        case 2:
            return bernstein_rows<size>(2, t, std::min<std::size_t>(order, 2));
        case 3:
            return bernstein_rows<size>(3, t, order);
        case 5:
            return bernstein_rows<size>(5, t, order);
        default:
            return bernstein_rows<size>(degree, t, std::min(order, degree));
    }
}

/// `size`: more than either degree.
template <std::size_t order, std::size_t size>
HomogeneousDerivatives homogeneous_derivatives(const BezierPatchView& patch, const Vec2& uv) {
    const auto degree_u = static_cast<std::size_t>(patch.degree_u);
    const auto degree_v = static_cast<std::size_t>(patch.degree_v);
    const auto bu = rows_of<order, size>(degree_u, uv.x);
    const auto bv = rows_of<order, size>(degree_v, uv.y);
    HomogeneousDerivatives result{};
    result.fill(zero_row());
    const Vec4* p = patch.points.data();
    for (std::size_t i = 0; i <= degree_u; ++i) {
        std::array<Vec4, 4> row = zero_row();
        for (std::size_t j = 0; j <= degree_v; ++j, ++p)
            for (std::size_t l = 0; l <= order; ++l) row[l] += *p * bv[l][j];
        for (std::size_t k = 0; k <= order; ++k)
            for (std::size_t l = 0; k + l <= order; ++l) result[k][l] += row[l] * bu[k][i];
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

/// Degree of by far the most patches and curves: rows of 8 are cleared in no time.
constexpr int common = 7;

template <std::size_t order>
SurfaceDerivatives derivatives(const BezierPatchView& patch, const Vec2& uv) {
    const HomogeneousDerivatives h =
        std::max(patch.degree_u, patch.degree_v) <= common
            ? homogeneous_derivatives<order, common + 1>(patch, uv)
            : homogeneous_derivatives<order, max_degree + 1>(patch, uv);
    SurfaceDerivatives result;
    for (std::size_t total = 0; total <= order; ++total)
        for (std::size_t k = 0; k <= total; ++k)
            result.d[k][total - k] = quotient(h, result, k, total - k);
    return result;
}

/// `size`: more than the degree.
template <std::size_t size>
std::array<Vec3, 4> homogeneous_derivatives(const BezierCurveView& curve, double t, int order) {
    const auto basis =
        bernstein_rows<size>(static_cast<std::size_t>(curve.degree()), t,
                             static_cast<std::size_t>(std::min(order, curve.degree())));
    std::array<Vec3, 4> h{};
    h.fill(Vec3(0));
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k)
        for (std::size_t i = 0; i < curve.points.size(); ++i) h[k] += curve.points[i] * basis[k][i];
    return h;
}

} // namespace

std::array<Vec2, 4> evaluate(const BezierCurveView& curve, double t, int order) {
    assert(order >= 0 && order <= 3);
    const std::array<Vec3, 4> h = curve.degree() <= common
                                      ? homogeneous_derivatives<common + 1>(curve, t, order)
                                      : homogeneous_derivatives<max_degree + 1>(curve, t, order);
    std::array<Vec2, 4> result{};
    result.fill(Vec2(0));
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
        Vec2 value(h[k].x, h[k].y);
        for (std::size_t i = 1; i <= k; ++i) value -= result[k - i] * (binomial[k][i] * h[i].z);
        result[k] = value / h[0].z;
    }
    return result;
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
