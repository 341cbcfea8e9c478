#include "keiko/light/tubes/tube_slices.h"

#include "keiko/math/quadrature.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {

namespace {

std::vector<AcrossNode> made(int nodes) {
    std::vector<AcrossNode> rule;
    double sum = 0;
    for (const QuadratureNode& node : gauss_legendre(nodes)) {
        rule.push_back({node.x, node.weight, std::sqrt(1 - node.x * node.x)});
        sum += rule.back().weight * rule.back().rim;
    }
    for (AcrossNode& node : rule) node.rim *= std::numbers::pi / 2 / sum;
    return rule;
}

} // namespace

std::span<const AcrossNode> width_quadrature(int nodes) {
    static const std::array<std::vector<AcrossNode>, 3> rules{made(1), made(2), made(4)};
    assert(nodes == 1 || nodes == 2 || nodes == 4);
    return rules[nodes == 4 ? 2 : static_cast<std::size_t>(nodes - 1)];
}

} // namespace keiko
