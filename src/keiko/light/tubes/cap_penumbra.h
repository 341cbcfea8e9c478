#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/tubes/tube_lamp.h"

namespace keiko {

/// Share, 0 to 1, that `point` with unit `normal` sees of what the cap that faces it brings, of all
/// of it above the horizon: by chords of its disc along the horizon, closer where what is seen of
/// neighbours is not in line, to about `tolerance`. What lies between the first 33 and hides none
/// of them is missed. 1 where no cap faces the point.
double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visibility& visible, double tolerance);

} // namespace keiko
