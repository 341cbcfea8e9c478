#include "keiko/intersect/roots/preconditioner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

struct Range {
    double low, high;

    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

/// Bounds of a partial derivative: of the coefficients' differences `step` apart.
Range derivative_range(const double* c, const PlanarNet& net, bool along_u, double slack) {
    const std::size_t columns = net.columns(), step = along_u ? columns : 1;
    const std::size_t rows = along_u ? net.rows() - 1 : net.rows();
    const std::size_t used = along_u ? columns : columns - 1;
    double low = 0, high = 0;
    bool first = true;
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < used; ++j) {
            const double d = c[i * columns + j + step] - c[i * columns + j];
            low = first ? d : std::min(low, d);
            high = first ? d : std::max(high, d);
            first = false;
        }
    const double degree = along_u ? net.degree_u : net.degree_v;
    return {degree * (low - 2 * slack), degree * (high + 2 * slack)};
}

struct Jacobian {
    Range fu, fv, gu, gv;

    explicit Jacobian(const Preconditioned& p)
        : fu(derivative_range(p.net.f.data(), p.net, true, p.slack_f)),
          fv(derivative_range(p.net.f.data(), p.net, false, p.slack_f)),
          gu(derivative_range(p.net.g.data(), p.net, true, p.slack_g)),
          gv(derivative_range(p.net.g.data(), p.net, false, p.slack_g)) {}
};

} // namespace

Preconditioned preconditioned(const PlanarNet& net, double slack) {
    const std::size_t last = net.size() - 1, row = net.columns() - 1, column = last - row;
    const auto mean = [&](const std::array<double, PlanarNet::capacity>& c) {
        return std::pair((c[column] + c[last] - c[0] - c[row]) / 2,
                         (c[row] + c[last] - c[0] - c[column]) / 2);
    };
    const auto [fu, fv] = mean(net.f);
    const auto [gu, gv] = mean(net.g);
    const double determinant = fu * gv - fv * gu;
    // Relative to the lengths, the determinant is the sine of the angle in which the ray sees
    // the parameter lines cross; below rounding it has no meaning.
    const double scale = std::hypot(fu, gu) * std::hypot(fv, gv);
    Preconditioned result;
    result.net.degree_u = net.degree_u;
    result.net.degree_v = net.degree_v;
    result.regular = std::abs(determinant) > 1e-14 * scale;
    const double a = result.regular ? gv / determinant : 1,
                 b = result.regular ? -fv / determinant : 0;
    const double c = result.regular ? -gu / determinant : 0,
                 d = result.regular ? fu / determinant : 1;
    for (std::size_t i = 0; i <= last; ++i) {
        result.net.f[i] = a * net.f[i] + b * net.g[i];
        result.net.g[i] = c * net.f[i] + d * net.g[i];
    }
    result.slack_f = (std::abs(a) + std::abs(b)) * slack;
    result.slack_g = (std::abs(c) + std::abs(d)) * slack;
    return result;
}

bool at_most_one_root(const Preconditioned& p) {
    if (!p.regular) return false;
    const Jacobian j(p);
    return j.fu.low > 0 && j.gv.low > 0 &&
           j.fu.low * j.gv.low > j.fv.magnitude() * j.gu.magnitude();
}

double contraction(const Preconditioned& p) {
    if (!p.regular) return std::numeric_limits<double>::infinity();
    const Jacobian j(p);
    const auto from_one = [](const Range& r) { return Range{r.low - 1, r.high - 1}.magnitude(); };
    return std::max(from_one(j.fu) + j.fv.magnitude(), from_one(j.gv) + j.gu.magnitude());
}

namespace {

/// Newton is at its goal here long before; a start that needs more is a bad one.
constexpr int most_steps = 12;
/// Bound, as a share of the square, above which it says nothing.
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
