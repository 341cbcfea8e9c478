#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"
#include "keiko/scene/criteria_preset.h"

#include <vector>

namespace keiko {

/// Longest wave as a share of the window, so that two of them fit in; dents bend no wider
/// (docs/theory/verdict.md).
constexpr double widest_share = 0.5;

/// A ripple of a line of constant u or v on a face.
struct FaceRipple {
    SheetPoint at;      ///< of its crest or trough
    Vec3 position{0};   ///< of `at`, world, mm
    Vec3 along{0};      ///< unit, direction of the line
    double width = 0;   ///< mm
    double depth = 0;   ///< mm, about; positive on crests
    double deepest = 0; ///< mm, as a Ripple's
    bool cut = false;   ///< cut by a border
};

/// All ripples of a face: lines are followed over smooth seams, and up to borders.
std::vector<FaceRipple> find_face_ripples(const FaceAdjacency& faces, std::size_t face,
                                          const WavinessLimit& limit);

/// Ripples grouped by flaw: those in the same or in neighbouring cells of space, `cell` mm wide, on
/// smoothly connected faces. In each group the deepest comes first.
std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell);

} // namespace keiko
