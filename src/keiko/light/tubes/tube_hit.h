#pragma once

#include "keiko/light/tubes/c_plane.h"

#include <optional>

namespace keiko {

/// First intersection of a ray with a lamp of a C-plane.
struct TubeHit {
    double t = 0;     ///< in lengths of the ray's direction
    int lamp = 0;     ///< index by rising v
    bool cap = false; ///< on an end disc
};

/// The first capped cylinder of the row that the ray enters at t > 0, tubes that hide each other
/// included; nullopt for a ray that starts inside a tube and meets no other.
std::optional<TubeHit> nearest_tube(const CPlaneFrame& frame, const Vec3& origin,
                                    const Vec3& direction);

/// Range of lamps of a row, by rising v, from begin up to but without end.
struct LampRange {
    int begin = 0, end = 0; ///< empty unless begin < end
};

/// Range of lamps that a cone about the unit direction `axis` from `point` can meet, its half angle
/// in radians (docs/theory/luminance.md#lobes); all of them if the plane does not bound the cone.
LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle);

} // namespace keiko
