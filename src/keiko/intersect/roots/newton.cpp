#include "keiko/intersect/roots/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Newton is at its goal here long before; a start that needs more is a bad one.
constexpr int most_steps = 12;
/// Of the square: a bound above this says nothing.
constexpr double poor_bound = 0.1;

/// Bound of the error of f and g at a place: of the coefficients, and of evaluating.
double noise(const Preconditioned& p) {
    double largest = 0;
    for (std::size_t i = 0; i < p.net.size(); ++i)
        largest = std::max({largest, std::abs(p.net.f[i]), std::abs(p.net.g[i])});
    const double steps = 4.0 * (p.net.degree_u + p.net.degree_v + 1);
    return std::max(p.slack_f, p.slack_g) +
           std::numeric_limits<double>::epsilon() * steps * largest;
}

double residual(const PlanarPoint& point) {
    return std::max(std::abs(point.value.x), std::abs(point.value.y));
}

} // namespace

std::optional<NewtonRoot> newton(const Preconditioned& p, const Vec2& start) {
    const double reach = 1 - contraction(p), blur = noise(p);
    if (!(reach > 0.05)) return std::nullopt;
    Vec2 uv = start;
    PlanarPoint here = evaluate(p.net, uv);
    for (int i = 0; i < most_steps; ++i) {
        const double scale = 1 / here.determinant();
        const Vec2 next = uv - Vec2((here.dv.y * here.value.x - here.dv.x * here.value.y) * scale,
                                    (here.du.x * here.value.y - here.du.y * here.value.x) * scale);
        if (!(next.x > -0.5 && next.x < 1.5 && next.y > -0.5 && next.y < 1.5)) return std::nullopt;
        const PlanarPoint there = evaluate(p.net, next);
        // What no longer gains on rounding is as good as it gets.
        if (!(residual(there) < residual(here))) break;
        uv = next;
        here = there;
    }
    // Above rounding it has not settled: another clip will say more.
    if (!(residual(here) <= 2 * blur)) return std::nullopt;
    const auto bound = [&] { return (residual(here) + blur) / reach; };
    const Box2 grown{Vec2(-bound()), Vec2(1 + bound())};
    if (!grown.contains(uv)) return std::nullopt;
    // The contraction is known of the square alone.
    if (!unit_square.contains(uv)) {
        uv = unit_square.nearest(uv);
        here = evaluate(p.net, uv);
    }
    const double error = bound();
    if (!(error < poor_bound)) return std::nullopt;
    return NewtonRoot{uv, Vec2(error)};
}

} // namespace keiko
