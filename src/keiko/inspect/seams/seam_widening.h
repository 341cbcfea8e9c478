#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"

#include <span>
#include <vector>

namespace keiko {

/// How much wider than the join distance a gap is followed.
constexpr double widest_gap = 10;

/// Seams that end because their gap grows past `join` mm, extended to where the borders part for
/// good: where either ends, they diverge by more than parallel_borders, the gap exceeds
/// `widest_gap` times `join`, or another seam begins on one of them. The others as they are. The
/// distance within which borders are paired is no limit of what is measured.
std::vector<Seam> widened_seams(const BoundaryCurves& curves, std::span<const Seam> seams,
                                double join);

} // namespace keiko
