#include "keiko/trace/scalar_net.h"

#include <algorithm>

namespace keiko {
namespace {

/// `lines` polynomials of `count` coefficients `step` apart, `stride` from line to line: cut down
/// to [a, b], in place.
void restrict_lines(double* c, std::size_t count, std::size_t step, std::size_t lines,
                    std::size_t stride, double a, double b) {
    const auto blend = [&](std::size_t to, std::size_t with, double t) {
        for (std::size_t k = 0; k < lines * stride; k += stride)
            c[to * step + k] += t * (c[with * step + k] - c[to * step + k]);
    };
    if (b != 1)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = count - 1; i >= level; --i) blend(i, i - 1, 1 - b);
    if (a != 0)
        for (std::size_t level = 1; level < count; ++level)
            for (std::size_t i = 0; i + level < count; ++i) blend(i, i + 1, a / b);
}

} // namespace

ScalarNet weighed(const HomogeneousNet& net, const Vec4& weights) {
    ScalarNet scalar{
        static_cast<std::size_t>(net.degree_u) + 1, static_cast<std::size_t>(net.degree_v) + 1, {}};
    scalar.c.reserve(net.points.size());
    for (const Vec4& p : net.points) scalar.c.push_back(p.dot(weights));
    return scalar;
}

ScalarNet restricted(const ScalarNet& net, const Box2& box) {
    ScalarNet part = net;
    restrict_lines(part.c.data(), part.rows, part.columns, part.columns, 1, box.lower.x,
                   box.upper.x);
    restrict_lines(part.c.data(), part.columns, 1, part.rows, part.columns, box.lower.y,
                   box.upper.y);
    return part;
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
    const auto [low, high] = std::minmax_element(net.c.begin(), net.c.end());
    return {(*low + *high) / 2, (*high - *low) / 2};
}

NetRange derivative_range(const ScalarNet& net, bool by_x) {
    return (by_x ? net.rows : net.columns) < 2 ? NetRange() : range(derivative(net, by_x));
}

} // namespace keiko
