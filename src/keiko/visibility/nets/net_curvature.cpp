#include "keiko/visibility/nets/net_curvature.h"

#include <algorithm>
#include <cmath>

namespace keiko {

bool NetCurvature::definite() const {
    if (xx.holds_zero() || yy.holds_zero() || (xx.middle > 0) != (yy.middle > 0)) return false;
    const double least = (std::abs(xx.middle) - xx.half) * (std::abs(yy.middle) - yy.half);
    return least > xy.largest() * xy.largest();
}

NetCurvature net_curvature(const ScalarNet& net) {
    NetCurvature second;
    if (net.rows > 1) {
        const ScalarNet by_x = derivative(net, true);
        second.xx = derivative_range(by_x, true);
        second.xy = derivative_range(by_x, false);
    }
    if (net.columns > 1) second.yy = derivative_range(derivative(net, false), false);
    return second;
}

NetCurvature net_curvature(const DegreeReducedScalar& lowered, const ScalarNet& exact) {
    NetCurvature second = net_curvature(lowered.net);
    const auto square = [](std::size_t count) {
        return static_cast<double>((count - 1) * (count - 1));
    };
    const double m = square(exact.rows), n = square(exact.columns);
    const double xx = m * (m - 1) / 3 * lowered.error, xy = m * n * lowered.error,
                 yy = n * (n - 1) / 3 * lowered.error;
    constexpr double little = 0.05;
    const double size = std::max({second.xx.largest(), second.xy.largest(), second.yy.largest()});
    if (!(std::max({xx, xy, yy}) <= little * size)) return net_curvature(exact);
    second.xx.half += xx;
    second.xy.half += xy;
    second.yy.half += yy;
    return second;
}

} // namespace keiko
