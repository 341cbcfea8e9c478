#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// Along a line on a surface.
struct BendPoint {
    double length = 0; ///< mm from the line's begin
    double bend = 0;   ///< 1/mm, normal curvature
};

/// Where the curvature along a line turns round, between two turns the other way. Where the
/// surface ends less than half a wave away, its border stands for one of the two.
struct Ripple {
    std::size_t index = 0; ///< into the line
    double width = 0;      ///< mm, twice the way to the nearer turn
    double depth = 0;   ///< mm, of a sine that bends as much; positive where the line bends least
    double deepest = 0; ///< mm, its size where each turn lies half a step of the line further off
    bool cut = false;   ///< by a border
};

/// Whether the surface ends where the line does.
struct LineEnds {
    bool at_begin = false, at_end = false;
};

/// The ripples of a line that are no wider than `window` and may be `depth` deep, mm. A bend of
/// the form, a fillet say, turns but once and is none.
std::vector<Ripple> find_ripples(std::span<const BendPoint> line, double depth, double window,
                                 const LineEnds& ends = {});

} // namespace keiko
