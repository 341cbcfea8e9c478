#pragma once

#include "keiko/light/tubes/c_plane_frame.h"

#include <optional>

namespace keiko {

/// Where a ray first meets a lamp of a C-plane.
struct TubeHit {
    double t = 0;     ///< in lengths of the ray's direction
    int lamp = 0;     ///< index by rising v
    bool cap = false; ///< on an end disc
};

/// The first capped cylinder of the comb that the ray enters at t > 0, tubes that hide each other
/// included; nothing for a ray that starts inside a tube and meets no other.
std::optional<TubeHit> nearest_tube(const CPlaneFrame& frame, const Vec3& origin,
                                    const Vec3& direction);

/// Width in mm of the strip of the C-plane through which rays of direction `d`, in frame
/// coordinates, meet an endless tube (docs/theory/luminance.md#in-mirrors); infinite for a
/// direction in the plane across the lamps.
double apparent_diameter(const CPlaneFrame& frame, const Vec3& d);

} // namespace keiko
