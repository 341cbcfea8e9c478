#include "tests/bench/equal_error.h"

#include <cmath>
#include <limits>
#include <span>

namespace keiko::bench {
namespace {

/// The straight line of least squares through logarithms: log y = first + slope log x.
struct PowerLaw {
    double first = 0, slope = 0;

    template <class Y>
    PowerLaw(std::span<const Cost> costs, const Y& y) {
        double x1 = 0, x2 = 0, y1 = 0, xy = 0;
        for (const Cost& cost : costs) {
            const double a = std::log(cost.rays), b = std::log(y(cost));
            x1 += a, x2 += a * a, y1 += b, xy += a * b;
        }
        const auto n = static_cast<double>(costs.size());
        slope = (n * xy - x1 * y1) / (n * x2 - x1 * x1);
        first = (y1 - slope * x1) / n;
    }
    double at(double x) const { return std::exp(first + slope * std::log(x)); }
    double where(double y) const { return std::exp((std::log(y) - first) / slope); }
};

} // namespace

double us_a_point(const Shares& shares) {
    return 1e6 * shares.seconds / static_cast<double>(shares.values.size());
}

Cost cost_at(const std::vector<Cost>& measured, double error) {
    const auto larger = std::span(measured).subspan(measured.size() / 2);
    const PowerLaw errors_of(larger, [](const Cost& c) { return c.error; });
    const PowerLaw times_of(larger, [](const Cost& c) { return c.us; });
    for (std::size_t i = 1; i < measured.size(); ++i) {
        const Cost &a = measured[i - 1], &b = measured[i];
        if (!(b.error <= error && a.error > error)) continue;
        const double t = std::log(error / a.error) / std::log(b.error / a.error);
        return {a.rays * std::pow(b.rays / a.rays, t), error, a.us * std::pow(b.us / a.us, t)};
    }
    const double rays = errors_of.where(error);
    return {rays, error, times_of.at(rays)};
}

Cost best_sampling(const std::vector<std::vector<Cost>>& ladders, double error) {
    Cost best{.us = std::numeric_limits<double>::infinity()};
    for (const auto& costs : ladders)
        if (const Cost cost = cost_at(costs, error); cost.us < best.us) best = cost;
    return best;
}

} // namespace keiko::bench
