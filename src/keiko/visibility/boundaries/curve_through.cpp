#include "keiko/visibility/boundaries/curve_through.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr std::size_t points = BoundaryPiece::points;

/// Of the Bernstein polynomials' values at the nodes, by Gauss and Jordan.
CurveMatrix inverse() {
    CurveMatrix values{}, inverse{};
    for (std::size_t k = 0; k < points; ++k) {
        BernsteinRow row{1};
        for (std::size_t n = 1; n < points; ++n) raise_degree(row, n, curve_node(k));
        std::copy_n(row.begin(), points, values[k].begin());
        inverse[k][k] = 1;
    }
    for (std::size_t k = 0; k < points; ++k) {
        const double pivot = values[k][k];
        for (std::size_t j = 0; j < points; ++j) values[k][j] /= pivot, inverse[k][j] /= pivot;
        for (std::size_t i = 0; i < points; ++i) {
            const double share = i == k ? 0 : values[i][k];
            for (std::size_t j = 0; j < points; ++j) {
                values[i][j] -= share * values[k][j];
                inverse[i][j] -= share * inverse[k][j];
            }
        }
    }
    return inverse;
}

} // namespace

double curve_node(std::size_t k) {
    return (1 - std::cos(std::numbers::pi * static_cast<double>(k) / (points - 1))) / 2;
}

const CurveMatrix& control_points_of_values() {
    static const CurveMatrix matrix = inverse();
    return matrix;
}

} // namespace keiko
