#include "keiko/visibility/nets/scalar_net.h"

#include "keiko/geometry/bernstein/coefficient_lines.h"
#include "keiko/math/interval.h"

#include <cmath>

namespace keiko {

namespace {

/// Lines along u, which lie side by side.
CoefficientLines lines_along_u(const ScalarNet& net) {
    return CoefficientLines::of_tensor(net.rows, net.columns, true);
}

ScalarNet transposed(const ScalarNet& net) {
    ScalarNet other{net.columns, net.rows, std::vector<double>(net.c.size())};
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j) other.at(j, i) = net.at(i, j);
    return other;
}

RunningRange range_of(const ScalarNet& net) {
    RunningRange all;
    all.add(net.c.size(), [&](std::size_t i) { return net.c[i]; });
    return all;
}

} // namespace

std::array<ScalarNet, 2> halved(const ScalarNet& net, unsigned axis) {
    std::array<ScalarNet, 2> halves{net, net};
    split_lines(halves[1].c.data(), halves[0].c.data(),
                CoefficientLines::of_tensor(net.rows, net.columns, axis == 0), 0.5);
    return halves;
}

std::array<HomogeneousNet, 2> halved(const HomogeneousNet& net, unsigned axis) {
    std::array<HomogeneousNet, 2> halves{net, net};
    const auto rows = static_cast<std::size_t>(net.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(net.degree_v) + 1;
    split_lines(halves[1].points.data(), halves[0].points.data(),
                CoefficientLines::of_tensor(rows, columns, axis == 0), 0.5);
    return halves;
}

ScalarNet weighed(const HomogeneousNet& net, const Vec4& weights) {
    ScalarNet scalar{
        static_cast<std::size_t>(net.degree_u) + 1, static_cast<std::size_t>(net.degree_v) + 1, {}};
    scalar.c.reserve(net.points.size());
    for (const Vec4& p : net.points) scalar.c.push_back(p.dot(weights));
    return scalar;
}

ScalarNet restricted(const ScalarNet& net, const Box2& box) {
    ScalarNet part = net;
    restrict_lines(part.c.data(), lines_along_u(part), box.lower.x, box.upper.x);
    part = transposed(part);
    restrict_lines(part.c.data(), lines_along_u(part), box.lower.y, box.upper.y);
    return transposed(part);
}

ScalarNet derivative(const ScalarNet& net, bool by_x) {
    ScalarNet d{net.rows - by_x, net.columns - !by_x, {}};
    d.c.resize(d.rows * d.columns);
    const double scale = static_cast<double>((by_x ? net.rows : net.columns) - 1) / 2;
    for (std::size_t i = 0; i < d.rows; ++i)
        for (std::size_t j = 0; j < d.columns; ++j)
            d.at(i, j) = scale * (net.at(i + by_x, j + !by_x) - net.at(i, j));
    return d;
}

NetRange range(const ScalarNet& net) {
    if (net.c.empty()) return {};
    const RunningRange all = range_of(net);
    return {(all.low() + all.high()) / 2, (all.high() - all.low()) / 2};
}

bool may_vanish(const ScalarNet& net, double error) {
    const RunningRange all = range_of(net);
    const double low = all.low(), high = all.high();
    const double slack = error + 1e-14 * std::max(std::abs(low), std::abs(high));
    return low <= slack && high >= -slack;
}

NetRange derivative_range(const ScalarNet& net, bool by_x) {
    if ((by_x ? net.rows : net.columns) < 2) return {};
    const double scale = static_cast<double>((by_x ? net.rows : net.columns) - 1) / 2;
    const std::size_t columns = net.columns - !by_x, ahead = by_x ? net.columns : 1;
    RunningRange steps;
    for (std::size_t i = 0; i + by_x < net.rows; ++i) {
        const double* const c = &net.c[i * net.columns];
        steps.add(columns, [&](std::size_t j) { return c[j + ahead] - c[j]; });
    }
    const double low = scale * steps.low(), high = scale * steps.high();
    return {(low + high) / 2, (high - low) / 2};
}

} // namespace keiko
