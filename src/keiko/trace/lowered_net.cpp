#include "keiko/trace/lowered_net.h"

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

/// Applies a matrix to the rows of a net, along u.
HomogeneousNet along_u(const Matrix& m, const HomogeneousNet& net) {
    HomogeneousNet result{static_cast<int>(m.rows) - 1, net.degree_v, {}};
    const auto columns = static_cast<std::size_t>(net.degree_v) + 1;
    result.points.assign(m.rows * columns, Vec4(0));
    for (std::size_t i = 0; i < m.rows; ++i)
        for (std::size_t k = 0; k < m.columns; ++k)
            for (std::size_t j = 0; j < columns; ++j)
                result.points[i * columns + j] += net.points[k * columns + j] * m.at(i, k);
    return result;
}

HomogeneousNet along_v(const Matrix& m, const HomogeneousNet& net) {
    HomogeneousNet result{net.degree_u, static_cast<int>(m.rows) - 1, {}};
    const auto columns = static_cast<std::size_t>(net.degree_v) + 1;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(net.degree_u); ++i)
        for (std::size_t j = 0; j < m.rows; ++j) {
            Vec4 sum(0);
            for (std::size_t k = 0; k < m.columns; ++k)
                sum += net.points[i * columns + k] * m.at(j, k);
            result.points.push_back(sum);
        }
    return result;
}

struct Pair {
    Matrix raise, lower;
};

/// Made once a thread and degree.
const Pair& matrices(int low, int high) {
    thread_local std::map<std::pair<int, int>, Pair> known;
    const auto at = known.find({low, high});
    if (at != known.end()) return at->second;
    const Matrix raise = raising(low, high);
    return known.emplace(std::pair(low, high), Pair{raise, lowering(raise)}).first->second;
}

} // namespace

LoweredNet lowered(const HomogeneousNet& net, int degree) {
    const bool in_u = net.degree_u > degree, in_v = net.degree_v > degree;
    LoweredNet result{net, Vec4(0)};
    if (in_u) result.net = along_u(matrices(degree, net.degree_u).lower, result.net);
    if (in_v) result.net = along_v(matrices(degree, net.degree_v).lower, result.net);
    HomogeneousNet raised = result.net;
    if (in_u) raised = along_u(matrices(degree, net.degree_u).raise, raised);
    if (in_v) raised = along_v(matrices(degree, net.degree_v).raise, raised);
    for (std::size_t i = 0; i < net.points.size(); ++i)
        for (unsigned k = 0; k < 4; ++k)
            result.error[k] =
                std::max(result.error[k], std::abs(net.points[i][k] - raised.points[i][k]));
    return result;
}

} // namespace keiko
