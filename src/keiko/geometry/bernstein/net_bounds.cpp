#include "keiko/geometry/bernstein/net_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// The half of a line of coefficients towards its end (`upper`) or its begin, in place.
void halve(double* c, std::size_t count, std::size_t step, bool upper) {
    for (std::size_t level = 1; level < count; ++level) {
        if (upper)
            for (std::size_t i = 0; i + level < count; ++i)
                c[i * step] = (c[i * step] + c[(i + 1) * step]) / 2;
        else
            for (std::size_t i = count - 1; i >= level; --i)
                c[i * step] = (c[(i - 1) * step] + c[i * step]) / 2;
    }
}

BernsteinNet quadrant(const BernsteinNet& net, bool upper_u, bool upper_v) {
    BernsteinNet part;
    part.rows = net.rows;
    part.columns = net.columns;
    std::copy_n(net.c.begin(), net.rows * net.columns, part.c.begin());
    for (std::size_t j = 0; j < net.columns; ++j) halve(&part.c[j], net.rows, net.columns, upper_u);
    for (std::size_t i = 0; i < net.rows; ++i)
        halve(&part.c[i * net.columns], net.columns, 1, upper_v);
    return part;
}

/// Coefficients of the derivative of a net over a quadrant, one unit wide: by x or by y.
BernsteinNet derivative(const BernsteinNet& net, bool by_x) {
    BernsteinNet d;
    d.rows = net.rows - (by_x ? 1 : 0);
    d.columns = net.columns - (by_x ? 0 : 1);
    const auto degree = static_cast<double>((by_x ? net.rows : net.columns) - 1);
    for (std::size_t i = 0; i < d.rows; ++i)
        for (std::size_t j = 0; j < d.columns; ++j)
            d.at(i, j) =
                degree * (by_x ? net.at(i + 1, j) - net.at(i, j) : net.at(i, j + 1) - net.at(i, j));
    return d;
}

/// Largest magnitude; 0 for the derivative of a constant, which has no coefficients.
double magnitude(const BernsteinNet& net) {
    double most = 0;
    for (std::size_t i = 0; i < net.rows * net.columns; ++i)
        most = std::max(most, std::abs(net.c[i]));
    return most;
}

void extend(NetBounds& b, const BernsteinNet& part) {
    for (std::size_t i = 0; i < part.rows * part.columns; ++i) {
        b.low = std::min(b.low, part.c[i]);
        b.high = std::max(b.high, part.c[i]);
    }
    const BernsteinNet x = derivative(part, true), y = derivative(part, false);
    const double xx = x.rows > 0 ? magnitude(derivative(x, true)) : 0;
    const double yy = y.columns > 0 ? magnitude(derivative(y, false)) : 0;
    const double xy = x.rows > 0 && x.columns > 0 ? magnitude(derivative(x, false)) : 0;
    b.slope = std::max(b.slope, magnitude(x) + magnitude(y));
    b.bend = std::max(b.bend, xx + 2 * xy + yy);
    b.bend_u = std::max(b.bend_u, xx);
    b.bend_v = std::max(b.bend_v, yy);
    b.twist = std::max(b.twist, xy);
}

} // namespace

NetBounds net_bounds(const BernsteinNet& net) {
    NetBounds b;
    b.low = std::numeric_limits<double>::infinity();
    b.high = -b.low;
    for (const bool upper_u : {false, true})
        for (const bool upper_v : {false, true}) extend(b, quadrant(net, upper_u, upper_v));
    // Halving m times rounds m times, a difference once more, and is multiplied by its degree.
    const auto steps = static_cast<double>(net.rows + net.columns);
    const double rounding = std::numeric_limits<double>::epsilon() * steps * magnitude(net);
    b.low -= rounding;
    b.high += rounding;
    b.slope += 4 * steps * rounding;
    b.bend += 16 * steps * steps * rounding;
    return b;
}

} // namespace keiko
