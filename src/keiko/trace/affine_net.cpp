#include "keiko/trace/affine_net.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Coefficients of one component, u outer.
struct ScalarNet {
    std::size_t rows, columns;
    std::vector<double> c;

    double& at(std::size_t i, std::size_t j) { return c[i * columns + j]; }
    double at(std::size_t i, std::size_t j) const { return c[i * columns + j]; }
};

ScalarNet component(const HomogeneousNet& net, unsigned k) {
    ScalarNet scalar{
        static_cast<std::size_t>(net.degree_u) + 1, static_cast<std::size_t>(net.degree_v) + 1, {}};
    for (const Vec4& p : net.points) scalar.c.push_back(p[k]);
    return scalar;
}

/// Takes the linear part off.
void subtract(ScalarNet& net, double along_x, double along_y) {
    const auto place = [](std::size_t i, std::size_t count) {
        return count < 2 ? 0 : 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
    };
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j)
            net.at(i, j) -= along_x * place(i, net.rows) + along_y * place(j, net.columns);
}

/// Coefficients of the derivative by x (or y) over [-1, 1]^2.
ScalarNet derivative(const ScalarNet& net, bool by_x) {
    ScalarNet d{net.rows - by_x, net.columns - !by_x, {}};
    d.c.resize(d.rows * d.columns);
    const double scale = static_cast<double>((by_x ? net.rows : net.columns) - 1) / 2;
    for (std::size_t i = 0; i < d.rows; ++i)
        for (std::size_t j = 0; j < d.columns; ++j)
            d.at(i, j) = scale * (net.at(i + by_x, j + !by_x) - net.at(i, j));
    return d;
}

/// Middle and half width of the values that a net may have.
struct Range {
    double middle = 0, half = 0;

    double largest() const { return std::abs(middle) + half; }
};

Range range(const ScalarNet& net) {
    if (net.c.empty()) return {};
    const auto [low, high] = std::minmax_element(net.c.begin(), net.c.end());
    return {(*low + *high) / 2, (*high - *low) / 2};
}

Range second_derivative(const ScalarNet& first, bool by_x) {
    return (by_x ? first.rows : first.columns) < 2 ? Range() : range(derivative(first, by_x));
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
    constexpr double rounding = 1e-14;
    for (unsigned k = 0; k < 4; ++k) {
        ScalarNet rest = component(net, k);
        subtract(rest, f.along_x[k], f.along_y[k]);
        const Range value = range(rest);
        f.value[k] = value.middle;
        f.off[k] = value.half + rounding * largest;
        const ScalarNet by_x = derivative(rest, true), by_y = derivative(rest, false);
        f.slope[k] = range(by_x).largest() + range(by_y).largest() + rounding * largest;
        const Range xx = second_derivative(by_x, true), xy = second_derivative(by_x, false),
                    yy = second_derivative(by_y, false);
        f.xx[k] = xx.middle, f.xx_range[k] = xx.half;
        f.xy[k] = xy.middle, f.xy_range[k] = xy.half;
        f.yy[k] = yy.middle, f.yy_range[k] = yy.half;
    }
    return f;
}

} // namespace keiko
