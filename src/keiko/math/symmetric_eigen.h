#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace keiko {

/// A square matrix by rows.
template <std::size_t N>
using SquareMatrix = std::array<std::array<double, N>, N>;

/// Eigenvalues of a symmetric matrix, in no order, and a unit eigenvector of each.
template <std::size_t N>
struct SymmetricEigen {
    std::array<double, N> values{};
    SquareMatrix<N> vectors{}; ///< the k-th row belongs to the k-th value
};

/// Eigenvalues and eigenvectors by cyclic Jacobi rotations [GolubVanLoan2013, 8.5.3], to rounding
/// of the largest one. Only for small matrices.
template <std::size_t N>
SymmetricEigen<N> symmetric_eigen(SquareMatrix<N> a) {
    SymmetricEigen<N> found;
    for (std::size_t k = 0; k < N; ++k) found.vectors[k][k] = 1;
    const auto rotate = [&](std::size_t p, std::size_t q) {
        if (a[p][q] == 0) return;
        const double cotangent = (a[q][q] - a[p][p]) / (2 * a[p][q]); // of twice the angle
        const double t =
            std::copysign(1.0, cotangent) / (std::abs(cotangent) + std::hypot(1, cotangent));
        const double c = 1 / std::hypot(1, t), s = t * c;
        const auto turn = [&](double& x, double& y) {
            const double old = x;
            x = c * old - s * y, y = s * old + c * y;
        };
        for (std::size_t k = 0; k < N; ++k) turn(a[k][p], a[k][q]);
        for (std::size_t k = 0; k < N; ++k) turn(a[p][k], a[q][k]);
        for (std::size_t k = 0; k < N; ++k) turn(found.vectors[p][k], found.vectors[q][k]);
    };
    constexpr int sweeps = 12; // it converges quadratically, after about five
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t p = 0; p < N; ++p)
            for (std::size_t q = p + 1; q < N; ++q) rotate(p, q);
    for (std::size_t k = 0; k < N; ++k) found.values[k] = a[k][k];
    return found;
}

} // namespace keiko
