#pragma once

#include <span>

namespace keiko {

/// One node of a rule on [-1, 1].
struct QuadratureNode {
    double x = 0, weight = 0;
};

/// Gauss-Legendre nodes on [-1, 1], computed once per order and kept; exact for polynomials of
/// degree 2 `order` - 1. Requires 1 <= order <= 64.
std::span<const QuadratureNode> gauss_legendre(int order);

/// Integral of f over [a, b] by one Gauss-Legendre panel.
template <class F>
auto integrate(const F& f, double a, double b, int order) {
    const double half = (b - a) / 2, middle = (a + b) / 2;
    const std::span<const QuadratureNode> nodes = gauss_legendre(order);
    const auto share = [&](const QuadratureNode& node) {
        return f(middle + half * node.x) * (node.weight * half);
    };
    auto sum = share(nodes.front());
    for (const QuadratureNode& node : nodes.subspan(1)) sum += share(node);
    return sum;
}

} // namespace keiko
