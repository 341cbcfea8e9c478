#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// A point along a line on a surface.
struct BendPoint {
    double length = 0; ///< mm from the line's begin
    double bend = 0;   ///< 1/mm, normal curvature
};

/// An extremum of the curvature along a line, between two opposite ones. If the surface ends less
/// than half a wave away, its border replaces one of the two.
struct Ripple {
    std::size_t index = 0; ///< into the line
    double width = 0;      ///< mm, twice the distance to the nearer turn
    double depth = 0;   ///< mm, of a sine with this curvature; positive where the line's curvature
                        ///< is least
    double deepest = 0; ///< mm, its size if each turn lies half a step of the line farther away
    bool cut = false;   ///< cut by a border
};

/// The ends of a line at which the surface ends too.
struct LineEnds {
    bool at_begin = false; ///< at the line's first point
    bool at_end = false;   ///< at the line's last point
};

/// The ripples of a line that are at most as wide as `window` and may be `depth` deep, mm. A bend
/// of the form such as a fillet turns only once and is no ripple.
std::vector<Ripple> find_ripples(std::span<const BendPoint> line, double depth, double window,
                                 const LineEnds& ends = {});

} // namespace keiko
