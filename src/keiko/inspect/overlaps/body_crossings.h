#pragma once

#include "keiko/inspect/overlaps/overlap.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// Bodies that pass through each other: a border of one makes its way through a face of another. It
/// leaves the tangent plane where it meets the face by more than half of `join` on both sides,
/// within `join` / 2 over sin `parallel_borders` of that place. One crossing for each pair of
/// bodies, the steepest; none for pairs with a crossing in `known`. Bodies are faces of one
/// instance joined by `seams`. Surfaces that cross without a border of either passing through the
/// other are not found. `join` in mm.
std::vector<Overlap> body_crossings(const ModelBorders& borders, std::span<const Seam> seams,
                                    std::span<const Overlap> known, double join,
                                    const Job& job = {});

} // namespace keiko
