#include "keiko/visibility/nets/degree_reduced_net.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace keiko {
namespace {

/// Rows outer.
struct Matrix {
    std::size_t rows, columns;
    std::vector<double> a;

    Matrix(std::size_t r, std::size_t c) : rows(r), columns(c), a(r * c, 0.0) {}
    double& at(std::size_t i, std::size_t j) { return a[i * columns + j]; }
    double at(std::size_t i, std::size_t j) const { return a[i * columns + j]; }
};

double binomial(int n, int k) {
    double value = 1;
    for (int i = 1; i <= k; ++i) value *= double(n - k + i) / i;
    return value;
}

/// Bernstein coefficients of degree `low` to those of degree `high`.
Matrix raising(int low, int high) {
    Matrix m(static_cast<std::size_t>(high) + 1, static_cast<std::size_t>(low) + 1);
    for (int i = 0; i <= high; ++i)
        for (int j = std::max(0, i - high + low); j <= std::min(i, low); ++j)
            m.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) =
                binomial(low, j) * binomial(high - low, i - j) / binomial(high, i);
    return m;
}

/// Its pseudo-inverse (E^T E)^-1 E^T, by Gauss-Jordan elimination: E^T E is positive definite.
Matrix lowering(const Matrix& raise) {
    const std::size_t n = raise.columns, m = raise.rows;
    Matrix normal(n, n), inverse(n, m);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t k = 0; k < m; ++k) normal.at(i, j) += raise.at(k, i) * raise.at(k, j);
        for (std::size_t k = 0; k < m; ++k) inverse.at(i, k) = raise.at(k, i);
    }
    for (std::size_t k = 0; k < n; ++k) {
        const double scale = 1 / normal.at(k, k);
        for (std::size_t j = 0; j < n; ++j) normal.at(k, j) *= scale;
        for (std::size_t j = 0; j < m; ++j) inverse.at(k, j) *= scale;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = normal.at(i, k);
            for (std::size_t j = 0; j < n; ++j) normal.at(i, j) -= factor * normal.at(k, j);
            for (std::size_t j = 0; j < m; ++j) inverse.at(i, j) -= factor * inverse.at(k, j);
        }
    }
    return inverse;
}

/// Coefficients of any kind, rows outer.
template <class T>
struct Grid {
    std::size_t rows, columns;
    std::vector<T> c;
};

/// Applies a matrix to the rows of a grid, along u.
template <class T>
Grid<T> along_u(const Matrix& m, const Grid<T>& grid) {
    Grid<T> result{m.rows, grid.columns, std::vector<T>(m.rows * grid.columns, T(0))};
    for (std::size_t i = 0; i < m.rows; ++i)
        for (std::size_t k = 0; k < m.columns; ++k) {
            if (m.at(i, k) == 0) continue;
            for (std::size_t j = 0; j < grid.columns; ++j)
                result.c[i * grid.columns + j] += grid.c[k * grid.columns + j] * m.at(i, k);
        }
    return result;
}

template <class T>
Grid<T> along_v(const Matrix& m, const Grid<T>& grid) {
    Grid<T> result{grid.rows, m.rows, std::vector<T>(grid.rows * m.rows, T(0))};
    for (std::size_t i = 0; i < grid.rows; ++i)
        for (std::size_t k = 0; k < m.columns; ++k)
            for (std::size_t j = 0; j < m.rows; ++j)
                result.c[i * m.rows + j] += grid.c[i * grid.columns + k] * m.at(j, k);
    return result;
}

struct Pair {
    Matrix raise, lower;
};

/// Made once a thread and degree.
const Pair& matrices(std::size_t low, std::size_t high) {
    thread_local std::map<std::pair<std::size_t, std::size_t>, Pair> known;
    const auto at = known.find({low, high});
    if (at != known.end()) return at->second;
    const Matrix raise = raising(static_cast<int>(low), static_cast<int>(high));
    return known.emplace(std::pair(low, high), Pair{raise, lowering(raise)}).first->second;
}

template <class T>
struct Fit {
    Grid<T> low;
    std::vector<T> off; ///< of the fit, raised again, from what was given
};

template <class T>
Fit<T> fit(Grid<T> grid, std::size_t degree) {
    const bool in_u = grid.rows > degree + 1, in_v = grid.columns > degree + 1;
    if (!in_u && !in_v) return {std::move(grid), {}};
    Grid<T> low = in_u ? along_u(matrices(degree, grid.rows - 1).lower, grid) : grid;
    if (in_v) low = along_v(matrices(degree, grid.columns - 1).lower, low);
    Grid<T> raised = in_v ? along_v(matrices(degree, grid.columns - 1).raise, low) : low;
    if (in_u) raised = along_u(matrices(degree, grid.rows - 1).raise, raised);
    for (std::size_t i = 0; i < grid.c.size(); ++i) grid.c[i] -= raised.c[i];
    return {std::move(low), std::move(grid.c)};
}

} // namespace

DegreeReducedNet lowered(const HomogeneousNet& net, int degree) {
    const auto rows = static_cast<std::size_t>(net.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(net.degree_v) + 1;
    Fit<Vec4> f = fit(Grid<Vec4>{rows, columns, net.points}, static_cast<std::size_t>(degree));
    DegreeReducedNet result{{static_cast<int>(f.low.rows) - 1, static_cast<int>(f.low.columns) - 1,
                             std::move(f.low.c)}};
    for (const Vec4& off : f.off)
        for (unsigned k = 0; k < 4; ++k)
            result.error[k] = std::max(result.error[k], std::abs(off[k]));
    return result;
}

DegreeReducedScalar lowered(const ScalarNet& net, std::size_t degree) {
    Fit<double> f = fit(Grid<double>{net.rows, net.columns, net.c}, degree);
    DegreeReducedScalar result{{f.low.rows, f.low.columns, std::move(f.low.c)}};
    for (const double off : f.off) result.error = std::max(result.error, std::abs(off));
    return result;
}

} // namespace keiko
