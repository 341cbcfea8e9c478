#include "keiko/math/quadrature.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

constexpr int max_order = 64;

struct Legendre {
    double value, derivative;
};

Legendre legendre(int order, double x) {
    double previous = 1, value = x;
    for (int k = 2; k <= order; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
        previous = value;
        value = next;
    }
    return {value, order * (x * value - previous) / (x * x - 1)};
}

std::vector<QuadratureNode> make_rule(int order) {
    if (order == 1) return {{0, 2}};
    std::vector<QuadratureNode> rule;
    for (int i = order; i >= 1; --i) {
        double x = std::cos(std::numbers::pi * (i - 0.25) / (order + 0.5));
        for (int step = 0; step < 8; ++step) {
            const Legendre p = legendre(order, x);
            x -= p.value / p.derivative;
        }
        const double slope = legendre(order, x).derivative;
        rule.push_back({x, 2 / ((1 - x * x) * slope * slope)});
    }
    return rule;
}

} // namespace

std::span<const QuadratureNode> gauss_legendre(int order) {
    assert(order >= 1 && order <= max_order);
    static const auto rules = [] {
        std::array<std::vector<QuadratureNode>, max_order + 1> all;
        for (int n = 1; n <= max_order; ++n) all[static_cast<std::size_t>(n)] = make_rule(n);
        return all;
    }();
    return rules[static_cast<std::size_t>(order)];
}

} // namespace keiko
