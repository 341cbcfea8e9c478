#include "keiko/visibility/nets/gradient_bounds.h"

#include "keiko/math/interval.h"

#include <algorithm>

namespace keiko {

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
