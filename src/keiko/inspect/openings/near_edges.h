#pragma once

#include "keiko/inspect/openings/free_edges.h"

#include <vector>

namespace keiko {

/// A stretch of a free edge that stays near those of other faces and yet is no seam with them.
struct NearEdges {
    FreePlace a, b;      ///< where they are farthest apart, b the nearest place of another face
    double distance = 0; ///< mm from a to b
    double length = 0;   ///< mm
};

/// The stretches within `join` mm, longer than the two sides of a corner are that near: edges that
/// leave one corner with an angle of `parallel_borders`. In the order of the edges.
std::vector<NearEdges> near_edges(const FreeEdges& edges, double join, const Job& job = {});

} // namespace keiko
