#pragma once

#include "keiko/light/tubes/c_plane_frame.h"

namespace keiko {

/// Lamps of a row, by rising v, from begin up to but without end.
struct LampRange {
    int begin = 0, end = 0;
};

/// Lamps that a cone about the unit direction `axis` from `point` can meet, its half angle in
/// radians (docs/theory/luminance.md#lobes); all of them where the cone is not bounded by the
/// plane.
LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle);

} // namespace keiko
