#pragma once

#include "keiko/light/tubes/c_plane_frame.h"
#include "keiko/math/ray_differentials.h"

namespace keiko {

/// The rays of a pixel, half a unit of the picture's x and y to all sides of its centre's, each
/// with a footprint of the pixel's size or a smaller one: nothing is known of them but bounds.
struct RayCone {
    Vec3 origin, direction;  ///< of the centre's ray
    RayDifferentials spread; ///< of the same
    /// How far the others are, at the most, from where that spread leads.
    double origin_rest = 0, direction_rest = 0;
    /// How far their own differentials are from it.
    double origin_slope_rest = 0, direction_slope_rest = 0;
};

/// Whether it is proved that look_up() finds no lamp of a C-plane for any ray of a bundle and its
/// footprint.
bool misses_lamps(const CPlaneFrame& frame, const RayCone& rays);

} // namespace keiko
