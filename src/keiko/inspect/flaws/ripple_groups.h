#pragma once

#include "keiko/inspect/flaws/face_ripples.h"

#include <vector>

namespace keiko {

/// The ripples of one flaw each: those in the same or in neighbouring cells of space, `cell` mm
/// wide, on faces that go on smoothly in each other. In each group the deepest first.
std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell);

} // namespace keiko
