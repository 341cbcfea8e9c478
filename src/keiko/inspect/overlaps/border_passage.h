#pragma once

#include "keiko/inspect/openings/free_edges.h"
#include "keiko/intersect/hit/hit.h"

namespace keiko {

/// The way of a border through a face that it meets at `hit`, `way` mm along the border.
struct BorderPassage {
    /// It leaves the tangent plane by more than half of `join` on both sides, within `join` / 2
    /// over sin `parallel_borders` of the hit.
    bool is_through = false;
    double length = 0; ///< mm of that way within `join` of the tangent plane
};

/// `join` in mm.
BorderPassage border_passage(const FreeEdge& border, double way, const Hit& hit, double join);

} // namespace keiko
