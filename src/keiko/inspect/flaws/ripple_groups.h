#pragma once

#include "keiko/inspect/flaws/face_ripples.h"

#include <vector>

namespace keiko {

/// Ripples grouped by flaw: those in the same or in neighbouring cells of space, `cell` mm wide, on
/// smoothly connected faces. In each group the deepest comes first.
std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell);

} // namespace keiko
