#pragma once

#include "keiko/inspect/basics/line_cells.h"

namespace keiko {

class ZeroFunction;

/// A place on a line.
struct LinePoint {
    Vec2 uv{0};    ///< patch parameters
    Vec3 place{0}; ///< mm, on the exact surface
};

/// A connected piece of one level's line on a patch.
struct PatchLine {
    std::uint32_t level = 0; ///< index of a requested level
    bool closed = false;     ///< the last point is the first one again
    bool proved = true;      ///< runs through proved cells only; otherwise its course is likely,
                             ///< not certain
    std::vector<LinePoint> points;
    double deviation = 0; ///< mm, about the largest distance between curve and chords
};

struct PatchLineOptions {
    double chord_error = 0.01; ///< mm
    LineCellOptions cells;
};

/// The zeros of a function in its cells: one arc a cell, joined where arcs share an end, in the
/// order of the cells. Ends and inner points of an arc are found between places of opposite sign,
/// so that no step can leave the arc for another.
std::vector<PatchLine> lines_through(std::span<const LineCell> cells, const ZeroFunction& f,
                                     double chord_error);

/// All lines of the levels on a patch without its trims, by lines_through; by rising level.
std::vector<PatchLine> patch_lines(const BezierPatchView& patch, const LineField& field,
                                   std::span<const double> levels,
                                   const PatchLineOptions& options = {});

} // namespace keiko
