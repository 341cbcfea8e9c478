#include "keiko/visibility/nets/degree_reduction.h"

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bezier/subpatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr std::size_t nodes = max_occluder_degree + 1;
using Matrix = std::array<std::array<double, nodes>, nodes>;

/// Chebyshev points of [0, 1], ends included.
double node(std::size_t i) {
    return 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(i) / (nodes - 1));
}

/// From values at the nodes to Bernstein coefficients, by Gauss-Jordan elimination with pivots.
Matrix coefficients_of_values() {
    Matrix a{}, inverse{};
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto row = bernstein_derivatives(max_occluder_degree, node(i), 0)[0];
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
    static const Matrix to_coefficients = coefficients_of_values();
    const int degree = static_cast<int>(line.size()) - 1;
    std::vector<Vec4> coefficients(nodes, Vec4(0));
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto row = bernstein_derivatives(degree, node(i), 0)[0];
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
