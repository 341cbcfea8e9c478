#pragma once

#include "keiko/light/tubes/c_plane.h"
#include "keiko/math/ray_differentials.h"

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

/// Width in mm of the strip of the C-plane through which rays of direction `d`, in frame
/// coordinates, meet an endless tube (docs/theory/luminance.md#in-mirrors); infinite for a
/// direction in the plane across the lamps.
double apparent_diameter(const CPlaneFrame& frame, const Vec3& d);

/// The rays of a pixel, half a unit of the picture's x and y to all sides of its centre's, each
/// with a footprint of the pixel's size or a smaller one. Only bounds of them are known.
struct RayCone {
    Vec3 origin, direction;  ///< of the centre's ray
    RayDifferentials spread; ///< of that ray
    /// Largest deviations of the other rays from those that the spread predicts.
    double origin_rest = 0, direction_rest = 0;
    /// Largest deviations of their own differentials from it.
    double origin_slope_rest = 0, direction_slope_rest = 0;
};

/// True if look_up() is proved to find no lamp of a C-plane for any ray of a bundle and its
/// footprint.
bool misses_lamps(const CPlaneFrame& frame, const RayCone& rays);

/// Range of lamps of a row, by rising v, from begin up to but without end.
struct LampRange {
    int begin = 0, end = 0; ///< empty unless begin < end
};

/// Range of lamps that a cone about the unit direction `axis` from `point` can meet, its half angle
/// in radians (docs/theory/luminance.md#lobes); all of them if the plane does not bound the cone.
LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle);

} // namespace keiko
