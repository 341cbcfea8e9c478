#include "keiko/geometry/bezier/bezier_curve.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include <algorithm>
#include <cassert>

namespace keiko {

std::array<Vec2, 4> evaluate(const BezierCurveView& curve, double t, int order) {
    assert(order >= 0 && order <= 3);
    const auto basis = bernstein_derivatives(curve.degree(), t, std::min(order, curve.degree()));
    std::array<Vec3, 4> h{};
    h.fill(Vec3(0));
    for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k)
        for (std::size_t i = 0; i < curve.points.size(); ++i) h[k] += curve.points[i] * basis[k][i];

    constexpr double binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
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

} // namespace keiko
