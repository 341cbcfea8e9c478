#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// Highest degree of curves and patches anywhere in Keiko.
constexpr int max_degree = 25;

/// Values of the Bernstein polynomials of one degree.
using BernsteinRow = std::array<double, max_degree + 1>;

/// The polynomials of degree n at t, in place of those of degree n - 1, in an array or vector.
/// Requires 1 <= n < its size.
template <class Row, class T>
void raise_degree(Row& row, std::size_t n, const T& t) {
    const T rest = T(1) - t;
    T before = row[0];
    row[0] = before * rest;
    for (std::size_t i = 1; i < n; ++i) {
        const T own = row[i];
        row[i] = rest * own + t * before;
        before = own;
    }
    row[n] = t * before;
}

/// B_i^degree at t, for i = 0..degree; the others are 0. Requires degree <= max_degree; t may lie
/// outside [0, 1].
BernsteinRow bernstein_values(int degree, double t);

/// rows[k][i] = k-th derivative of B_i^degree at both components of t, for k = 0..order and i =
/// 0..degree; the others are not set, as clearing them takes longer than all the rest. Requires
/// degree < size and order <= 3; t may lie outside [0, 1].
template <std::size_t order, std::size_t size>
std::array<std::array<Vec2, size>, order + 1> bernstein_rows(std::size_t degree, const Vec2& t) {
    assert(degree < size && order <= 3);
    std::array<std::array<Vec2, size>, order + 1> rows;
    for (std::size_t k = degree + 1; k <= order; ++k) rows[k].fill(Vec2(0));
    std::array<Vec2, size> row;
    row[0] = Vec2(1);
    for (std::size_t n = 0;; ++n) {
        if (const std::size_t k = degree - n; k <= order) {
            std::array<Vec2, size>& derived = rows[k];
            for (std::size_t i = 0; i <= n; ++i) derived[i] = row[i];
            // d/dt B_i^m = m (B_{i-1} - B_i), of degree m - 1
            for (std::size_t m = n + 1; m <= degree; ++m) {
                const auto factor = static_cast<double>(m);
                derived[m] = derived[m - 1] * factor;
                for (std::size_t i = m - 1; i > 0; --i)
                    derived[i] = (derived[i - 1] - derived[i]) * factor;
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
