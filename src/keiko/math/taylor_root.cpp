#include "keiko/math/taylor_root.h"

#include "keiko/math/taylor_peak.h"

#include <limits>

namespace keiko {
namespace {

/// f of a model, from f and its derivatives, each over its factorial, at the model's constant; the
/// fourth where it is largest.
TaylorModel composed(const TaylorModel& model, const std::array<double, 5>& f) {
    TaylorModel step(model);
    step.c[0] = 0;
    TaylorModel value = step * (step * (step * f[3] + f[2]) + f[1]) + f[0];
    const double r = model.deviation();
    value.error += r * r * r * r * std::abs(f[4]);
    const double size =
        std::abs(f[0]) + r * (std::abs(f[1]) + r * (std::abs(f[2]) + r * std::abs(f[3])));
    value.error += taylor_rounding::product * (size + value.error);
    return value;
}

/// The model is nowhere less.
double lower_bound(const TaylorModel& model) {
    return -peak(-model).bound;
}

TaylorModel unknown() {
    TaylorModel model;
    model.error = std::numeric_limits<double>::infinity();
    return model;
}

} // namespace

TaylorModel sqrt(const TaylorModel& model) {
    const double g = model.c[0], low = lower_bound(model);
    if (!(low > 0)) return unknown();
    const double f = std::sqrt(g);
    return composed(model, {f, 0.5 / f, -0.125 / (g * f), 0.0625 / (g * g * f),
                            5.0 / 128 / (low * low * low * std::sqrt(low))});
}

TaylorModel inverse_cubed_root(const TaylorModel& model) {
    const double g = model.c[0], low = lower_bound(model);
    if (!(low > 0)) return unknown();
    const double f = 1 / (g * std::sqrt(g));
    const double low2 = low * low;
    return composed(model, {f, -1.5 * f / g, 1.875 * f / (g * g), -2.1875 * f / (g * g * g),
                            2.4609375 / (low2 * low2 * low * std::sqrt(low))});
}

} // namespace keiko
