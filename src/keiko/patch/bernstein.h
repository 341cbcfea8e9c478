#pragma once

#include <array>

namespace keiko {

/// Highest degree of curves and patches anywhere in Keiko.
constexpr int max_degree = 25;

/// Values of the Bernstein polynomials of one degree, or of one of their derivatives.
using BernsteinRow = std::array<double, max_degree + 1>;

/// rows[k][i] = k-th derivative of B_i^degree at t, for k = 0..order. Requires
/// degree <= max_degree and order <= 3; t may lie outside [0, 1].
std::array<BernsteinRow, 4> bernstein_derivatives(int degree, double t, int order);

} // namespace keiko
