#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/bounds.h"

#include <array>

namespace keiko {

/// A box along three unit axes of its own; may be flat.
struct OrientedBox {
    Vec3 center{0};
    std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    Vec3 half{0}; ///< half the edge lengths
};

OrientedBox oriented(const Box3& box);
/// The room that the lamps of a C-plane take.
OrientedBox oriented(const CPlane& plane);

/// Whether two boxes have a point in common (separating axes [Gottschalk1996]).
bool overlap(const OrientedBox& a, const OrientedBox& b);

} // namespace keiko
