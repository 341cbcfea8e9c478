#include "keiko/trace/affine_net.h"

#include "keiko/trace/net_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

BernsteinNet component(const HomogeneousNet& net, unsigned k) {
    BernsteinNet c;
    c.rows = static_cast<std::size_t>(net.degree_u) + 1;
    c.columns = static_cast<std::size_t>(net.degree_v) + 1;
    for (std::size_t i = 0; i < net.points.size(); ++i) c.c[i] = net.points[i][k];
    return c;
}

/// Takes the affine part off.
void subtract(BernsteinNet& net, double value, double along_x, double along_y) {
    const auto place = [](std::size_t i, std::size_t count) {
        return count < 2 ? 0 : 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
    };
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j)
            net.at(i, j) -= value + along_x * place(i, net.rows) + along_y * place(j, net.columns);
}

struct Range {
    double middle = 0, half = 0;
};

/// Coefficients of the derivative by x (or y) over [-1, 1]^2.
BernsteinNet derivative(const BernsteinNet& net, bool by_x) {
    BernsteinNet d;
    d.rows = net.rows - (by_x ? 1 : 0);
    d.columns = net.columns - (by_x ? 0 : 1);
    const double scale = static_cast<double>((by_x ? net.rows : net.columns) - 1) / 2;
    for (std::size_t i = 0; i < d.rows; ++i)
        for (std::size_t j = 0; j < d.columns; ++j)
            d.at(i, j) = scale * (net.at(i + by_x, j + !by_x) - net.at(i, j));
    return d;
}

Range second_derivative(const BernsteinNet& net, bool first_by_x, bool second_by_x) {
    const std::size_t u = first_by_x + second_by_x, v = 2 - u;
    if (net.rows <= u || net.columns <= v) return {};
    const BernsteinNet d = derivative(derivative(net, first_by_x), second_by_x);
    const auto [low, high] = std::minmax_element(d.c.begin(), d.c.begin() + d.rows * d.columns);
    return {(*low + *high) / 2, (*high - *low) / 2};
}

} // namespace

AffineNet affine_net(const HomogeneousNet& net) {
    const int m = net.degree_u, n = net.degree_v;
    const BezierPatchView view = net.view();
    const Vec4 &a = view.point(0, 0), &b = view.point(m, 0), &c = view.point(0, n),
               &d = view.point(m, n);
    AffineNet f;
    if (m > 0) f.along_x = (b + d - a - c) / 4;
    if (n > 0) f.along_y = (c + d - a - b) / 4;
    double largest = 0;
    for (const Vec4& p : net.points) largest = std::max(largest, p.length());
    for (unsigned k = 0; k < 4; ++k) {
        BernsteinNet rest = component(net, k);
        const Range xx = second_derivative(rest, true, true),
                    xy = second_derivative(rest, true, false),
                    yy = second_derivative(rest, false, false);
        f.xx[k] = xx.middle, f.xx_range[k] = xx.half;
        f.xy[k] = xy.middle, f.xy_range[k] = xy.half;
        f.yy[k] = yy.middle, f.yy_range[k] = yy.half;
        subtract(rest, 0, f.along_x[k], f.along_y[k]);
        const NetBounds bounds = net_bounds(rest);
        constexpr double rounding = 1e-14;
        f.value[k] = (bounds.low + bounds.high) / 2;
        f.off[k] = (bounds.high - bounds.low) / 2 + rounding * largest;
        f.slope[k] = bounds.slope + rounding * largest;
    }
    return f;
}

} // namespace keiko
