#include "keiko/trace/affine_net.h"

#include "keiko/trace/scalar_net.h"

#include <algorithm>

namespace keiko {
namespace {

ScalarNet component(const HomogeneousNet& net, unsigned k) {
    Vec4 weights(0);
    weights[k] = 1;
    return weighed(net, weights);
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
        const NetRange value = range(rest);
        f.value[k] = value.middle;
        f.off[k] = value.half + rounding * largest;
        f.slope[k] = derivative_range(rest, true).largest() +
                     derivative_range(rest, false).largest() + rounding * largest;
        const auto bend = [&](bool first_by_x, bool second_by_x) {
            const bool enough = (first_by_x ? rest.rows : rest.columns) > 1;
            return enough ? derivative_range(derivative(rest, first_by_x), second_by_x)
                          : NetRange();
        };
        const NetRange xx = bend(true, true), xy = bend(true, false), yy = bend(false, false);
        f.xx[k] = xx.middle, f.xx_range[k] = xx.half;
        f.xy[k] = xy.middle, f.xy_range[k] = xy.half;
        f.yy[k] = yy.middle, f.yy_range[k] = yy.half;
    }
    return f;
}

} // namespace keiko
