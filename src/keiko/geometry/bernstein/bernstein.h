#pragma once

#include <array>
#include <cstddef>

namespace keiko {

/// Highest degree of curves and patches anywhere in Keiko.
constexpr int max_degree = 25;

/// Values of the Bernstein polynomials of one degree, or of one of their derivatives.
using BernsteinRow = std::array<double, max_degree + 1>;

/// The polynomials of degree n at t, in place of those of degree n - 1. Requires 1 <= n < size.
template <std::size_t size>
void raise_degree(std::array<double, size>& row, std::size_t n, double t) {
    row[n] = t * row[n - 1];
    for (std::size_t i = n - 1; i > 0; --i) row[i] = (1 - t) * row[i] + t * row[i - 1];
    row[0] *= 1 - t;
}

/// rows[k][i] = k-th derivative of B_i^degree at t, for k = 0..order. Requires
/// degree <= max_degree and order <= 3; t may lie outside [0, 1].
std::array<BernsteinRow, 4> bernstein_derivatives(int degree, double t, int order);

} // namespace keiko
