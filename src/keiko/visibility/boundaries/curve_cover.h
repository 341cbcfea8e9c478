#pragma once

#include "keiko/geometry/model/surface_curve.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// The direction into the surface that goes on beyond a curve, at its parameter and place; nothing
/// where none does.
using Beyond = std::function<std::optional<Vec3>(double, const Vec3&)>;

/// Pieces that cover a curve, each as `kind` except for what follows from the curve. They are as
/// short as it takes to be within 1e-9 of the curve's size, or rounding. The distance of a piece to
/// its curve is added to the kind's error. None for a curve that is a point.
std::vector<BoundaryPiece> curve_cover(const SurfaceCurve& curve, const Beyond& beyond,
                                       const BoundaryPiece& kind);

/// Matrix of the values or control points of a curve of degree 5, rows outer.
using CurveMatrix = std::array<std::array<double, BoundaryPiece::points>, BoundaryPiece::points>;

/// Parameter of the k-th place that a curve through places is given by: Chebyshev's in [0, 1], both
/// ends among them.
double curve_node(std::size_t k);

/// Matrix that turns values at the nodes into the control points of the polynomial through them.
const CurveMatrix& control_points_of_values();

/// Control points of the curve of degree 5 that has these values at the nodes.
template <class T>
std::array<T, BoundaryPiece::points> curve_through(
    const std::array<T, BoundaryPiece::points>& values) {
    const CurveMatrix& matrix = control_points_of_values();
    std::array<T, BoundaryPiece::points> curve = values;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        curve[i] = values[0] * matrix[i][0];
        for (std::size_t k = 1; k < values.size(); ++k) curve[i] += values[k] * matrix[i][k];
    }
    return curve;
}

} // namespace keiko
