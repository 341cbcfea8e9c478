#include "keiko/base/error.h"
#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/import/cad/surface_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace keiko::cad {
namespace {

constexpr int degree = 8;
constexpr std::size_t order = degree + 1;
constexpr int deepest = 6;

using Matrix = std::array<std::array<double, order>, order>;

double node(std::size_t k) {
    return (1 - std::cos(std::numbers::pi * static_cast<double>(k) / degree)) / 2;
}

/// Inverse by Gauss-Jordan elimination with row exchange.
Matrix inverted(Matrix m) {
    Matrix inverse{};
    for (std::size_t i = 0; i < order; ++i) inverse[i][i] = 1;
    for (std::size_t column = 0; column < order; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column; row < order; ++row)
            if (std::abs(m[row][column]) > std::abs(m[pivot][column])) pivot = row;
        std::swap(m[pivot], m[column]);
        std::swap(inverse[pivot], inverse[column]);
        const double scale = 1 / m[column][column];
        for (double& x : m[column]) x *= scale;
        for (double& x : inverse[column]) x *= scale;
        for (std::size_t row = 0; row < order; ++row) {
            const double factor = m[row][column];
            if (row == column || factor == 0) continue;
            for (std::size_t k = 0; k < order; ++k) {
                m[row][k] -= factor * m[column][k];
                inverse[row][k] -= factor * inverse[column][k];
            }
        }
    }
    return inverse;
}

/// Takes values at the nodes to Bernstein coefficients.
const Matrix& to_bernstein() {
    static const Matrix matrix = [] {
        Matrix values{};
        for (std::size_t k = 0; k < order; ++k) {
            const auto row = bernstein_values(degree, node(k));
            std::copy_n(row.begin(), order, values[k].begin());
        }
        return inverted(values);
    }();
    return matrix;
}

using Grid = std::array<std::array<Vec3, order>, order>;

Grid combined(const Matrix& m, const Grid& g) {
    Grid result;
    for (std::size_t i = 0; i < order; ++i)
        for (std::size_t j = 0; j < order; ++j) {
            Vec3 sum(0);
            for (std::size_t k = 0; k < order; ++k) sum += g[k][j] * m[i][k];
            result[i][j] = sum;
        }
    return result;
}

Grid transposed(const Grid& g) {
    Grid result;
    for (std::size_t i = 0; i < order; ++i)
        for (std::size_t j = 0; j < order; ++j) result[i][j] = g[j][i];
    return result;
}

SurfacePatch interpolated(const SurfacePoint& surface, const ParameterMap& u,
                          const ParameterMap& v) {
    Grid values;
    for (std::size_t i = 0; i < order; ++i)
        for (std::size_t j = 0; j < order; ++j)
            values[i][j] = surface(u.to_face(node(i)), v.to_face(node(j)));
    const Grid points =
        transposed(combined(to_bernstein(), transposed(combined(to_bernstein(), values))));
    SurfacePatch patch{u, v, degree, degree, {}};
    for (const auto& row : points)
        for (const Vec3& p : row) patch.points.emplace_back(p.x, p.y, p.z, 1);
    return patch;
}

double deviation(const SurfacePoint& surface, const SurfacePatch& patch) {
    double worst = 0;
    for (std::size_t i = 0; i + 1 < order; ++i)
        for (std::size_t j = 0; j + 1 < order; ++j) {
            const Vec2 uv((node(i) + node(i + 1)) / 2, (node(j) + node(j + 1)) / 2);
            const Vec3 wanted = surface(patch.map_u.to_face(uv.x), patch.map_v.to_face(uv.y));
            const BezierPatchView view{degree, degree, patch.points};
            worst = std::max(worst, (evaluate(view, uv, 0).position() - wanted).length());
        }
    return worst;
}

ParameterMap half(const ParameterMap& map, bool second) {
    const double middle = (map.begin + map.end) / 2;
    return second ? ParameterMap{map.kind, middle, map.end}
                  : ParameterMap{map.kind, map.begin, middle};
}

void append(SurfacePatches& result, const SurfacePoint& surface, const ParameterMap& u,
            const ParameterMap& v, double tolerance, int depth) {
    SurfacePatch patch = interpolated(surface, u, v);
    const double off = deviation(surface, patch);
    if (off <= tolerance) {
        result.approximated = std::max(result.approximated, off);
        result.patches.push_back(std::move(patch));
        return;
    }
    if (depth == deepest)
        throw Error(
            "", "",
            "its surface is too rough to be approximated: " + std::to_string(off) + " mm off");
    for (int quarter = 0; quarter < 4; ++quarter)
        append(result, surface, half(u, quarter & 2), half(v, quarter & 1), tolerance, depth + 1);
}

} // namespace

SurfacePatches interpolated_patches(const SurfacePoint& surface, const std::vector<double>& cuts_u,
                                    const std::vector<double>& cuts_v, double tolerance) {
    constexpr double rounding = 1e-10; // mm: what is interpolated is never exact
    SurfacePatches result{{}, rounding};
    for (std::size_t i = 0; i + 1 < cuts_u.size(); ++i)
        for (std::size_t j = 0; j + 1 < cuts_v.size(); ++j)
            append(result, surface, {ParameterMap::Kind::affine, cuts_u[i], cuts_u[i + 1]},
                   {ParameterMap::Kind::affine, cuts_v[j], cuts_v[j + 1]}, tolerance, 0);
    return result;
}

} // namespace keiko::cad
