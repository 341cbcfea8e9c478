#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/tube_lamp.h"

namespace keiko {

/// Visible share, 0 to 1, of the light of the cap that faces `point` with unit `normal`, relative
/// to all of it above the horizon. It is sampled by chords of the cap's disc along the horizon,
/// closer where the visibilities of neighbours are not in line, to about `tolerance`. Occluders
/// that lie between the first 33 chords and hide none of them are missed. 1 if no cap faces the
/// point.
double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visibility& visible, double tolerance);

} // namespace keiko
