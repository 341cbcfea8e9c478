#pragma once

#include "keiko/geometry/bernstein/bernstein.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace keiko {

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

} // namespace keiko
