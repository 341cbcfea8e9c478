#pragma once

#include "keiko/geometry/model/surface_curve.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// The direction into the surface that goes on beyond a curve, at its parameter and place; nothing
/// where none does.
using Beyond = std::function<std::optional<Vec3>(double, const Vec3&)>;

/// Pieces that cover a curve, each as `kind` but for what follows from the curve: as short as it
/// takes to be within 1e-9 of the curve's size, or rounding. What a piece is off its curve is added
/// to the kind's error. None for a curve that is a point.
std::vector<BoundaryPiece> curve_cover(const SurfaceCurve& curve, const Beyond& beyond,
                                       const BoundaryPiece& kind);

} // namespace keiko
