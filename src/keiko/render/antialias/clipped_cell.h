#pragma once

#include "keiko/render/antialias/edge_cell.h"

#include <array>

namespace keiko {

/// What an outline leaves of a cell on one side of it.
struct CutPart {
    SampledPolygon seen;
    Vec2 beside_cut{0}; ///< a place in it by the middle of the cut, px
};

/// A cell that one outline cuts along a straight line.
struct ClippedCell {
    SeenCell seen;
    std::array<CutPart, 2> parts;

    /// Crossings by rising side.
    ClippedCell(const SeenCell& cell, const EdgeCrossing& first, const EdgeCrossing& second);

    /// Whether the centre, where that is known, shows what its part has to.
    bool holds_centre() const;
};

} // namespace keiko
