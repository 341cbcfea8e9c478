#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/tubes/tube_lamp.h"

namespace keiko {

/// Share, 0 to 1, that `point` with unit `normal` sees of what the cap that faces it brings, of all
/// of it above the horizon: by chords of its disc along the horizon, more of them until twice as
/// many are within `tolerance`. 1 where no cap faces the point.
double seen_share_of_cap(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                         const Visible& visible, double tolerance);

} // namespace keiko
