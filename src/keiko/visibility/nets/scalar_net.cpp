#include "keiko/visibility/nets/scalar_net.h"

#include "keiko/math/interval.h"

#include <cmath>

namespace keiko {

namespace {

/// Cuts polynomials of `count` coefficients down to [a, b], in place, by two de Casteljau splits;
/// `blend(to, with, t)` moves coefficients towards others.
template <class Blend>
void cut_down(std::size_t count, double a, double b, const Blend& blend) {
    if (b != 1)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = count - 1; i >= level; --i) blend(i, i - 1, 1 - b);
    if (a != 0)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = 0; i + level < count; ++i) blend(i, i + 1, a / b);
}

/// All columns at once, so that they run side by side.
void restrict_rows(ScalarNet& net, double a, double b) {
    cut_down(net.rows, a, b, [&](std::size_t to, std::size_t with, double t) {
        double* const c = &net.at(to, 0);
        const double* const d = &net.at(with, 0);
        for (std::size_t k = 0; k < net.columns; ++k) c[k] += t * (d[k] - c[k]);
    });
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

/// One de Casteljau split at the middle: `low` becomes the lower half's coefficients, `high` the
/// upper's. Lines of `count` coefficients `step` apart, `lines` of them `apart` from each other.
template <class T>
void split_lines(std::vector<T>& low, std::vector<T>& high, std::size_t count, std::size_t step,
                 std::size_t lines, std::size_t apart) {
    high = low;
    for (std::size_t level = 1; level < count; ++level)
        for (std::size_t i = 0; i + level < count; ++i)
            for (std::size_t k = 0; k < lines; ++k) {
                T& c = high[i * step + k * apart];
                c = (c + high[(i + 1) * step + k * apart]) * 0.5;
                if (i == 0) low[level * step + k * apart] = c;
            }
}

template <class T>
void split(std::vector<T>& low, std::vector<T>& high, std::size_t rows, std::size_t columns,
           unsigned axis) {
    if (axis == 0)
        split_lines(low, high, rows, columns, columns, 1);
    else
        split_lines(low, high, columns, 1, rows, columns);
}

} // namespace

std::array<ScalarNet, 2> halved(const ScalarNet& net, unsigned axis) {
    std::array<ScalarNet, 2> halves{net, ScalarNet{net.rows, net.columns, {}}};
    split(halves[0].c, halves[1].c, net.rows, net.columns, axis);
    return halves;
}

std::array<HomogeneousNet, 2> halved(const HomogeneousNet& net, unsigned axis) {
    std::array<HomogeneousNet, 2> halves{net, HomogeneousNet{net.degree_u, net.degree_v, {}}};
    split(halves[0].points, halves[1].points, static_cast<std::size_t>(net.degree_u) + 1,
          static_cast<std::size_t>(net.degree_v) + 1, axis);
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
    restrict_rows(part, box.lower.x, box.upper.x);
    part = transposed(part);
    restrict_rows(part, box.lower.y, box.upper.y);
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
