#pragma once

#include "keiko/light/tubes/c_plane_frame.h"

namespace keiko {

/// One end of a lamp as it looks on the plane, at q across its strip, -1 to 1: the curve
/// u = at + shear q + bulge sqrt(1 - q^2), half of the image of a rim.
struct LampEnd {
    double at = 0; ///< mm along u, as the others
    double shear = 0, bulge = 0;
};

/// The ends of a row's lamps as they look on the plane; the same for each.
struct LampEnds {
    LampEnd begin, end;

    /// Straight across.
    static LampEnds straight(const CPlaneFrame& frame) { return {{0}, {frame.length}}; }
    /// As rays of a direction, in frame coordinates, meet round tubes: each end looks moved by
    /// where they meet the rim above or below the plane, times their slope along the lamps. Dark
    /// caps hide the near half of the rim, luminous ones show both.
    static LampEnds of_tubes(const CPlaneFrame& frame, const Vec3& d);
    /// Whether rays meet caps that are dark at the begin.
    bool begins_with_cap() const { return begin.bulge > 0; }
};

/// How far an end of a round tube may look moved along u, mm: by rays of that direction, in frame
/// coordinates.
double end_room(const CPlaneFrame& frame, const Vec3& d);

} // namespace keiko
