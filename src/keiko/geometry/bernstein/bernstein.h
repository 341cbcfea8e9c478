#pragma once

#include "keiko/base/export.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

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

/// rows[k][i] = k-th derivative of B_i^degree at t, for k = 0..order; the others are 0. Requires
/// degree < size and order <= 3; t may lie outside [0, 1]. A smaller `size` means less memory to
/// clear.
template <std::size_t size>
std::array<std::array<double, size>, 4> bernstein_rows(std::size_t degree, double t,
                                                       std::size_t order) {
    assert(degree < size && order <= 3);
    std::array<std::array<double, size>, 4> rows{};
    std::array<double, size> row{};
    row[0] = 1;
    for (std::size_t n = 0;; ++n) {
        if (const std::size_t k = degree - n; k <= order) {
            std::array<double, size>& derived = rows[k];
            for (std::size_t i = 0; i <= n; ++i) derived[i] = row[i];
            // d/dt B_i^m = m (B_{i-1} - B_i), of degree m - 1
            for (std::size_t m = n + 1; m <= degree; ++m) {
                const auto factor = static_cast<double>(m);
                derived[m] = factor * derived[m - 1];
                for (std::size_t i = m - 1; i > 0; --i)
                    derived[i] = factor * (derived[i - 1] - derived[i]);
                derived[0] *= -factor;
            }
        }
        if (n == degree) return rows;
        raise_degree(row, n + 1, t);
    }
}

/// Every root in the open interval (0, 1) of a polynomial given by its Bernstein coefficients,
/// rising. Coefficients up to `noise` in size count as zero. Subdivision by sign variation
/// [LaneRiesenfeld1981] misses no simple root. A multiple root is returned once or twice, as
/// accurately as `noise` permits. It is missed if rounding beyond `noise` has lifted it off zero.
/// An interval on which the polynomial is zero throughout has none.
std::vector<double> bernstein_roots(std::span<const double> coefficients, double noise);

} // namespace keiko
