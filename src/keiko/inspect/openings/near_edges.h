#pragma once

#include "keiko/inspect/openings/free_edges.h"

#include <vector>

namespace keiko {

/// A stretch of a free edge that stays near those of other faces without being a seam with them.
struct NearEdges {
    FreePlace a, b;      ///< the places farthest apart, b the nearest place of another face
    double distance = 0; ///< mm from a to b
    double length = 0;   ///< mm
};

/// The stretches within `join` mm, in the order of the edges. They are longer than the two sides of
/// a corner stay that near: edges that leave one corner at an angle of `parallel_borders`.
std::vector<NearEdges> near_edges(const FreeEdges& edges, double join, const Job& job = {});

} // namespace keiko
