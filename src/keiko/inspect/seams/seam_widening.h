#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"

#include <span>
#include <vector>

namespace keiko {

/// Ratio of the widest gap that is followed to the join distance.
constexpr double widest_gap = 10;

/// Seams that end because their gap grows past `join` mm are extended to where the borders part for
/// good. That is where either ends, they diverge by more than parallel_borders, the gap exceeds
/// `widest_gap` times `join`, or another seam begins on one of them. Other seams are unchanged. The
/// distance within which borders are paired thus does not limit the measurement.
std::vector<Seam> widened_seams(const BoundaryCurves& curves, std::span<const Seam> seams,
                                double join);

} // namespace keiko
