#include "keiko/intersect/roots/planar_net.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bernstein/coefficient_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

/// Values and first derivatives of the Bernstein polynomials, without the cost of higher ones.
struct Basis {
    BernsteinRow value, derivative;

    Basis(int degree, double t) {
        const auto at = [](BernsteinRow& row, int i) -> double& {
            return row[static_cast<std::size_t>(i)];
        };
        at(value, 0) = 1;
        for (int n = 1; n < degree; ++n) raise_degree(value, static_cast<std::size_t>(n), t);
        if (degree == 0) {
            at(derivative, 0) = 0;
            return;
        }
        at(derivative, 0) = -degree * at(value, 0);
        for (int i = 1; i < degree; ++i)
            at(derivative, i) = degree * (at(value, i - 1) - at(value, i));
        at(derivative, degree) = degree * at(value, degree - 1);
        raise_degree(value, static_cast<std::size_t>(degree), t);
    }
};

} // namespace

PlanarNet restricted(const PlanarNet& net, const Box2& box) {
    const std::size_t rows = net.rows(), columns = net.columns();
    PlanarNet part;
    part.degree_u = net.degree_u;
    part.degree_v = net.degree_v;
    std::copy_n(net.f.begin(), net.size(), part.f.begin());
    std::copy_n(net.g.begin(), net.size(), part.g.begin());
    for (double* c : {part.f.data(), part.g.data()}) {
        restrict_lines(c, CoefficientLines::of_tensor(rows, columns, true), box.lower.x,
                       box.upper.x);
        restrict_lines(c, CoefficientLines::of_tensor(rows, columns, false), box.lower.y,
                       box.upper.y);
    }
    return part;
}

PlanarPoint evaluate(const PlanarNet& net, const Vec2& uv) {
    const Basis u(net.degree_u, uv.x), v(net.degree_v, uv.y);
    PlanarPoint p{Vec2(0), Vec2(0), Vec2(0)};
    for (std::size_t i = 0, at = 0; i < net.rows(); ++i) {
        Vec2 along(0), slope(0);
        for (std::size_t j = 0; j < net.columns(); ++j, ++at) {
            const Vec2 c(net.f[at], net.g[at]);
            along += c * v.value[j];
            slope += c * v.derivative[j];
        }
        p.value += along * u.value[i];
        p.du += along * u.derivative[i];
        p.dv += slope * u.value[i];
    }
    return p;
}

Vec2 variation(const PlanarNet& net) {
    const std::size_t rows = net.rows(), columns = net.columns();
    const auto difference = [&](std::size_t a, std::size_t b) {
        return std::abs(net.f[a] - net.f[b]) + std::abs(net.g[a] - net.g[b]);
    };
    Vec2 most(0);
    for (std::size_t j = 0; j < columns; ++j) {
        double sum = 0;
        for (std::size_t i = 1; i < rows; ++i)
            sum += difference(i * columns + j, (i - 1) * columns + j);
        most.x = std::max(most.x, sum);
    }
    for (std::size_t i = 0; i < rows; ++i) {
        double sum = 0;
        for (std::size_t j = 1; j < columns; ++j)
            sum += difference(i * columns + j, i * columns + j - 1);
        most.y = std::max(most.y, sum);
    }
    return most;
}

std::optional<Vec2> containing_plane(const PlanarNet& net, double slack) {
    const std::size_t last = net.size() - 1, row = net.columns() - 1, column = last - row;
    // The widest chord gives the direction across which a flat net has no extent.
    Vec2 chord(0);
    for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, last}, {row, column}}) {
        const Vec2 d(net.f[b] - net.f[a], net.g[b] - net.g[a]);
        if (d.length2() > chord.length2()) chord = d;
    }
    if (!(chord.length2() > 0)) return std::nullopt;
    const Vec2 plane = Vec2(-chord.y, chord.x) / chord.length();
    for (std::size_t i = 0; i <= last; ++i)
        if (!(std::abs(plane.x * net.f[i] + plane.y * net.g[i]) <= slack)) return std::nullopt;
    return plane;
}

namespace {

constexpr ParameterInterval nothing{1, 0};

/// Heights at equally spaced places from 0 to 1.
struct Profile {
    std::array<double, max_degree + 1> height;
    std::size_t count;
};

/// Range in which the lower convex hull of a profile is at most zero: outside of it the hull stays
/// above, bounded by the steepest chord from a positive height down to a negative one.
ParameterInterval below_zero(const Profile& p) {
    const std::size_t n = p.count - 1;
    if (n == 0) return p.height[0] <= 0 ? ParameterInterval{0, 1} : nothing;
    const auto crossing = [&](std::size_t above, std::size_t below) {
        const double x = static_cast<double>(above), y = static_cast<double>(below);
        return (x + (y - x) * (p.height[above] / (p.height[above] - p.height[below]))) /
               static_cast<double>(n);
    };
    double begin = p.height[0] <= 0 ? 0 : 2, end = p.height[n] <= 0 ? 1 : -1;
    for (std::size_t i = 0; i <= n; ++i) {
        if (!(p.height[i] > 0)) continue;
        for (std::size_t k = i + 1; k <= n; ++k)
            if (p.height[k] <= 0) begin = std::min(begin, crossing(i, k));
        for (std::size_t k = 0; k < i; ++k)
            if (p.height[k] <= 0) end = std::max(end, crossing(i, k));
    }
    if (begin > 1 || end < 0) return nothing; // positive everywhere
    return {begin, end};
}

} // namespace

ParameterInterval clip_interval(std::span<const double> net, std::size_t rows, std::size_t columns,
                                Axis axis, double slack) {
    const std::size_t count = axis == Axis::u ? rows : columns;
    const std::size_t across = axis == Axis::u ? columns : rows;
    const std::size_t step = axis == Axis::u ? columns : 1;
    const std::size_t stride = axis == Axis::u ? 1 : columns;
    Profile low, minus_high;
    low.count = minus_high.count = count;
    for (std::size_t i = 0; i < count; ++i) {
        const double* c = net.data() + i * step;
        double lowest = c[0], highest = c[0];
        for (std::size_t k = 1; k < across; ++k) {
            lowest = std::min(lowest, c[k * stride]);
            highest = std::max(highest, c[k * stride]);
        }
        low.height[i] = lowest - slack;
        minus_high.height[i] = -highest - slack;
    }
    const ParameterInterval a = below_zero(low), b = below_zero(minus_high);
    // The division above rounds; an interval may only ever be too wide.
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double begin = std::max(a.begin, b.begin) - rounding;
    const double end = std::min(a.end, b.end) + rounding;
    return begin <= end ? ParameterInterval{std::max(begin, 0.0), std::min(end, 1.0)} : nothing;
}

} // namespace keiko
