#pragma once

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/inspect/flaws/face_adjacency.h"
#include "keiko/scene/criteria_preset.h"

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace keiko {

// The ripples of a line, and those of a face along its lines.

/// A point along a line on a surface.
struct BendPoint {
    double length = 0; ///< mm from the line's begin
    SecondForm bend;   ///< 1/mm, x along the line
};

/// An extremum of the curvature along a line, between two opposite ones. If the surface ends less
/// than half a wave away, its border replaces one of the two.
struct Ripple {
    std::size_t index = 0; ///< into the line
    double width = 0;      ///< mm, along the line: twice the distance to the nearer turn
    double slant = 0;      ///< radians: from the line to the way square to the crest
    double depth = 0;   ///< mm, of a sine with this curvature; positive where the line's curvature
                        ///< is least
    double deepest = 0; ///< mm, its size if each turn lies half a step of the line farther away
    bool cut = false;   ///< cut by a border

    /// mm: the width square to the crest.
    double square_width() const;
};

/// Largest size of a ripple's slant, radians. Of two families of lines that cross at 60 to 120
/// degrees, one crosses any crest at less.
constexpr double most_slant = std::numbers::pi / 3;

/// The ends of a line at which the surface ends too.
struct LineEnds {
    bool at_begin = false; ///< at the line's first point
    bool at_end = false;   ///< at the line's last point
};

/// The ripples of a line that along it are at most as wide as `window` and may be `depth` deep, mm.
/// A bend of the form such as a fillet turns only once and is no ripple.
std::vector<Ripple> find_ripples(std::span<const BendPoint> line, double depth, double window,
                                 const LineEnds& ends = {});

/// Longest wave as a share of the window, so that two of them fit in; dents bend no wider
/// (docs/theory/verdict.md).
constexpr double widest_share = 0.5;

/// A ripple of a line of constant u or v on a face.
struct FaceRipple {
    SheetPoint at;      ///< of its crest or trough
    Vec3 position{0};   ///< of `at`, world, mm
    Vec3 along{0};      ///< unit, square to the crest
    double width = 0;   ///< mm, along `along`
    double depth = 0;   ///< mm, about; positive on crests
    double deepest = 0; ///< mm, as a Ripple's
    bool cut = false;   ///< cut by a border
    bool askew = false; ///< too wide along its line, and narrow enough only along `along`
};

/// True if a face is so small that its samples for a limit are at most 10 million.
bool is_searchable(const FaceSurface& face, const WavinessLimit& limit);

/// All ripples of a face: lines are followed over smooth seams, and up to borders.
std::vector<FaceRipple> find_face_ripples(const FaceAdjacency& faces, std::size_t face,
                                          const WavinessLimit& limit);

/// Ripples grouped by flaw: those in the same or in neighbouring cells of space, `cell` mm wide, on
/// smoothly connected faces. In each group the deepest comes first.
std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell);

} // namespace keiko
