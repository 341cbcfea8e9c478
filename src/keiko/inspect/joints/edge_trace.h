#pragma once

#include "keiko/inspect/joints/panel_borders.h"

#include <optional>

namespace keiko {

/// A section plane across a joint, and the direction in it from a panel to the other one.
struct EdgePlane {
    Vec3 origin{0};  ///< a point of the plane, world, mm
    Vec3 along{0};   ///< unit normal of the plane, along the joint
    Vec3 forward{0}; ///< unit, in the plane: from the panel's skin over the joint
};

/// The edge of a panel in a section plane.
struct PanelEdge {
    Vec3 foremost{0};        ///< world, mm: the point of the roll that is farthest forward
    double radius = 0;       ///< mm, the smallest of the roll; 0 for a sharp edge
    double approximated = 0; ///< mm, the largest Face::approximated of its faces
    /// Direction of the section where it was followed to, away from the skin; unit. 0 at a free
    /// edge.
    Vec3 onward{0};
};

/// Result of following a section beyond a border of a skin.
struct EdgeResult {
    std::optional<PanelEdge> edge; ///< nullopt if the panel does not end there
    bool is_unmeasured = false;    ///< the section was lost, so that nothing is known
};

/// Follows the section of a panel from a place of a border over the roll beyond it. The panel ends
/// at a free edge, at a crease of `least_edge_turn` or more, or in a roll that turns by as much.
/// The roll ends where it is foremost, at a crease, at a free edge, or at a seam to a face that is
/// flatter across the joint than `largest_radius` mm. Positions are exact on the surfaces.
EdgeResult trace_edge(const PanelBorders& borders, const PanelBorder& border, double t,
                      const EdgePlane& plane, double largest_radius);

/// Radians by which a section turns, at least, where a panel ends.
constexpr double least_edge_turn = 0.7853981633974483;

} // namespace keiko
