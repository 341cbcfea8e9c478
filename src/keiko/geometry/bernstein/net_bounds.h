#pragma once

#include "keiko/geometry/bernstein/bernstein.h"

#include <array>

namespace keiko {

/// Bernstein coefficients, u outer, of a function of (x, y) over [-1, 1]^2.
struct BernsteinNet {
    static constexpr std::size_t capacity = std::size_t{max_degree + 1} * (max_degree + 1);

    std::size_t rows, columns;
    std::array<double, capacity> c; ///< beyond rows * columns undefined

    double& at(std::size_t i, std::size_t j) { return c[i * columns + j]; }
    double at(std::size_t i, std::size_t j) const { return c[i * columns + j]; }
};

/// Bounds over [-1, 1]^2 of a function f and its derivatives by x and y.
struct NetBounds {
    double low = 0, high = 0;                 ///< of f
    double slope = 0;                         ///< of |f_x| + |f_y|
    double bend = 0;                          ///< of |f_xx| + 2 |f_xy| + |f_yy|
    double bend_u = 0, bend_v = 0, twist = 0; ///< of |f_xx|, |f_yy|, |f_xy|
};

/// Bounds by the convex hulls of the four quadrants' coefficients. For a parabola over the whole
/// these are exact, while the hull of the whole is twice too wide. Rounding is included.
NetBounds net_bounds(const BernsteinNet& net);

} // namespace keiko
