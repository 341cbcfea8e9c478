#pragma once

#include "keiko/render/outline_cell.h"
#include "keiko/render/picture_part.h"

#include <array>
#include <vector>

namespace keiko {

/// What an outline leaves of a cell on one side of it.
struct CutPart {
    PicturePart part{};
    std::vector<const EyeSample*> around{}; ///< seen at its corners
    double across = 0;                      ///< the lamps, in pitches: mean of what is seen there
    Vec2 beside_cut{0};                     ///< a place in it by the middle of the cut, px

    /// Whether a sample shows what the part has to.
    bool shows(const EyeSample& sample) const;
    /// Whether a sample amid it tells how all of it looks; `size`: of the cell, px.
    bool is_told_by(const EyeSample& amid, double size) const;
};

/// A cell that one outline cuts along a straight line.
struct CutCell {
    SeenCell seen;
    std::array<CutPart, 2> parts;

    /// Crossings by rising side.
    CutCell(const SeenCell& cell, const CrossedSide& first, const CrossedSide& second);

    /// Whether the centre, where that is known, shows what its part has to.
    bool holds_centre() const;
};

} // namespace keiko
