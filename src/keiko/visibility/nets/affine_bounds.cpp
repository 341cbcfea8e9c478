#include "keiko/visibility/nets/affine_bounds.h"

#include "keiko/math/interval.h"
#include "keiko/visibility/nets/scalar_net.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keiko {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Ranges of each component; in arrays, so that components run side by side.
struct Ranges {
    std::array<double, 4> low{infinity, infinity, infinity, infinity};
    std::array<double, 4> high{-infinity, -infinity, -infinity, -infinity};

    void add(const Vec4& p) {
        const std::array<double, 4> c{p.x, p.y, p.z, p.w};
        for (std::size_t k = 0; k < 4; ++k) {
            low[k] = c[k] < low[k] ? c[k] : low[k];
            high[k] = c[k] > high[k] ? c[k] : high[k];
        }
    }
    Vec4 middle() const { return (vec(low) + vec(high)) / 2; }
    Vec4 half() const { return (vec(high) - vec(low)) / 2; }
    /// Largest distances from a place.
    Vec4 farthest(const Vec4& from) const {
        const Vec4 below = from - vec(low), above = vec(high) - from;
        Vec4 most(0);
        for (unsigned k = 0; k < 4; ++k) most[k] = std::max(below[k], above[k]);
        return most;
    }

private:
    static Vec4 vec(const std::array<double, 4>& c) { return {c[0], c[1], c[2], c[3]}; }
};

/// In [-1, 1], of a row or column.
double place(int i, int degree) {
    return degree > 0 ? 2 * static_cast<double>(i) / degree - 1 : 0;
}

/// Bound of the derivative along an axis, from the steps between neighbours, without the affine
/// part's.
Vec4 slope(const Ranges& steps, const Vec4& along, int degree) {
    if (degree == 0) return Vec4(0);
    const double half = static_cast<double>(degree) / 2;
    return steps.farthest(along / half) * half;
}

} // namespace

AffineBounds affine_bounds(const HomogeneousNet& net) {
    const int m = net.degree_u, n = net.degree_v;
    const BezierPatchView view = net.view();
    const Vec4 &a = view.point(0, 0), &b = view.point(m, 0), &c = view.point(0, n),
               &d = view.point(m, n);
    AffineBounds f;
    if (m > 0) f.along_x = (b + d - a - c) / 4;
    if (n > 0) f.along_y = (c + d - a - b) / 4;
    const auto columns = static_cast<std::size_t>(n) + 1;
    Ranges rest, by_u, by_v;
    for (int i = 0; i <= m; ++i) {
        const Vec4* const row = &net.points[static_cast<std::size_t>(i) * columns];
        const Vec4 of_row = f.along_x * place(i, m);
        for (std::size_t j = 0; j < columns; ++j) {
            rest.add(row[j] - of_row - f.along_y * place(static_cast<int>(j), n));
            if (i < m) by_u.add(row[j + columns] - row[j]);
            if (j + 1 < columns) by_v.add(row[j + 1] - row[j]);
        }
    }
    f.value = rest.middle();
    f.off = rest.half();
    constexpr double rounding = 1e-14;
    const Vec4 sizes = magnitudes(f.value) + magnitudes(f.along_x) + magnitudes(f.along_y) + f.off;
    const Vec4 room(rounding * sizes.length());
    f.off += room;
    f.slope = slope(by_u, f.along_x, m) + slope(by_v, f.along_y, n) + room;
    return f;
}

namespace {

ScalarNet component(const HomogeneousNet& net, unsigned k) {
    Vec4 weights(0);
    weights[k] = 1;
    return weighed(net, weights);
}

} // namespace

AffineNet affine_net(const HomogeneousNet& net) {
    AffineNet f{affine_bounds(net)};
    for (unsigned k = 0; k < 4; ++k) {
        const ScalarNet of = component(net, k);
        const auto bend = [&](bool first_by_x, bool second_by_x) {
            const bool enough = (first_by_x ? of.rows : of.columns) > 1;
            return enough ? derivative_range(derivative(of, first_by_x), second_by_x) : NetRange();
        };
        const NetRange xx = bend(true, true), xy = bend(true, false), yy = bend(false, false);
        f.xx[k] = xx.middle, f.xx_range[k] = xx.half;
        f.xy[k] = xy.middle, f.xy_range[k] = xy.half;
        f.yy[k] = yy.middle, f.yy_range[k] = yy.half;
    }
    return f;
}

unsigned GradientBounds::axis_to_halve(const Vec2& size) const {
    // Along a strip it takes many halvings where across it none helps.
    constexpr double slimmest = 1.0 / 256;
    if (size.x < slimmest * size.y) return 1;
    if (size.y < slimmest * size.x) return 0;
    return bend.x >= bend.y ? 0 : 1;
}

void GradientBounds::add_error(double error, const Vec2& shares) {
    constexpr double degree = 3 * max_occluder_degree - 1;
    all.off += error;
    all.slope += degree * degree * error * (shares.x + shares.y);
}

GradientBounds slopes_of(const ScalarNet& net) {
    const auto place = [](std::size_t i, std::size_t count) {
        return count < 2 ? 0 : 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
    };
    const NetRange x = derivative_range(net, true), y = derivative_range(net, false);
    RunningRange rest;
    const double step = net.columns < 2 ? 0 : 2 / static_cast<double>(net.columns - 1);
    for (std::size_t i = 0; i < net.rows; ++i) {
        const double* const c = &net.c[i * net.columns];
        const double at_row = x.middle * place(i, net.rows);
        rest.add(net.columns, [&](std::size_t j) {
            const double at_column = net.columns < 2 ? 0 : static_cast<double>(j) * step - 1;
            return c[j] - at_row - y.middle * at_column;
        });
    }
    const double low = rest.low(), high = rest.high();
    const double size = std::abs(x.middle) + std::abs(y.middle);
    return {{(low + high) / 2, x.middle, y.middle, (high - low) / 2, x.half + y.half},
            Vec2(x.half, y.half) / std::max(size, x.half + y.half)};
}

} // namespace keiko
