#include "keiko/visibility/nets/degree_reduced_net.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
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

namespace {

constexpr std::size_t nodes = max_occluder_degree + 1;
using NodeMatrix = std::array<std::array<double, nodes>, nodes>;

/// Chebyshev points of [0, 1], ends included.
double node(std::size_t i) {
    return 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / (nodes - 1));
}

/// From values at the nodes to Bernstein coefficients, by Gauss-Jordan elimination with pivots.
NodeMatrix coefficients_of_values() {
    NodeMatrix a{}, inverse{};
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto row = bernstein_values(max_occluder_degree, node(i));
        for (std::size_t j = 0; j < nodes; ++j) a[i][j] = row[j];
        inverse[i][i] = 1;
    }
    for (std::size_t k = 0; k < nodes; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < nodes; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(inverse[k], inverse[pivot]);
        const double scale = 1 / a[k][k];
        for (std::size_t j = 0; j < nodes; ++j) a[k][j] *= scale, inverse[k][j] *= scale;
        for (std::size_t i = 0; i < nodes; ++i) {
            const double factor = i == k ? 0 : a[i][k];
            for (std::size_t j = 0; factor != 0 && j < nodes; ++j) {
                a[i][j] -= factor * a[k][j];
                inverse[i][j] -= factor * inverse[k][j];
            }
        }
    }
    return inverse;
}

/// A line of coefficients with the highest degree in place of a higher one.
std::vector<Vec4> reduced_line(const std::vector<Vec4>& line) {
    static const NodeMatrix to_coefficients = coefficients_of_values();
    const int degree = static_cast<int>(line.size()) - 1;
    std::vector<Vec4> coefficients(nodes, Vec4(0));
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto row = bernstein_values(degree, node(i));
        Vec4 value(0);
        for (std::size_t j = 0; j < line.size(); ++j) value += line[j] * row[j];
        for (std::size_t j = 0; j < nodes; ++j) coefficients[j] += value * to_coefficients[j][i];
    }
    return coefficients;
}

HomogeneousNet transposed(const HomogeneousNet& net) {
    HomogeneousNet other{net.degree_v, net.degree_u, {}};
    for (int j = 0; j <= net.degree_v; ++j)
        for (int i = 0; i <= net.degree_u; ++i) other.points.push_back(net.view().point(i, j));
    return other;
}

/// Lowers the degree in v.
HomogeneousNet reduced_in_v(const HomogeneousNet& net) {
    if (net.degree_v <= max_occluder_degree) return net;
    HomogeneousNet less{net.degree_u, max_occluder_degree, {}};
    for (int i = 0; i <= net.degree_u; ++i) {
        std::vector<Vec4> line;
        for (int j = 0; j <= net.degree_v; ++j) line.push_back(net.view().point(i, j));
        const std::vector<Vec4> short_line = reduced_line(line);
        less.points.insert(less.points.end(), short_line.begin(), short_line.end());
    }
    return less;
}

double error_of(const HomogeneousNet& reduced, const HomogeneousNet& exact) {
    constexpr int probes = 11;
    double most = 0;
    for (int i = 0; i < probes; ++i)
        for (int j = 0; j < probes; ++j) {
            const Vec2 uv((i + 0.5) / probes, (j + 0.5) / probes);
            const Vec3 off = evaluate(reduced.view(), uv, 0).position() -
                             evaluate(exact.view(), uv, 0).position();
            most = std::max(most, off.length());
        }
    return most;
}

void reduce(const HomogeneousNet& whole, const Box2& uv, double tolerance, int halvings,
            std::vector<ReducedPatch>& parts) {
    constexpr int most_halvings = 8;
    const HomogeneousNet exact{whole.degree_u, whole.degree_v, subpatch(whole.view(), uv)};
    HomogeneousNet reduced = transposed(reduced_in_v(transposed(reduced_in_v(exact))));
    if (halvings >= most_halvings || error_of(reduced, exact) <= tolerance) {
        parts.push_back({uv, std::move(reduced)});
        return;
    }
    const bool along_u = whole.degree_u > max_occluder_degree &&
                         (halvings % 2 == 0 || whole.degree_v <= max_occluder_degree);
    Box2 low = uv, high = uv;
    const unsigned axis = along_u ? 0 : 1;
    low.upper[axis] = high.lower[axis] = uv.center()[axis];
    reduce(whole, low, tolerance, halvings + 1, parts);
    reduce(whole, high, tolerance, halvings + 1, parts);
}

} // namespace

std::vector<ReducedPatch> degree_reduction(HomogeneousNet patch) {
    std::vector<ReducedPatch> parts;
    if (std::max(patch.degree_u, patch.degree_v) <= max_occluder_degree) {
        parts.push_back({unit_square, std::move(patch)});
        return parts;
    }
    constexpr double accuracy = 1e-11;
    reduce(patch, unit_square, accuracy * hull_bounds(patch.view()).size(), 0, parts);
    return parts;
}

} // namespace keiko
