#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/tubes/lamp_width.h"
#include "keiko/tubes/tube_lamp.h"

#include <span>
#include <vector>

namespace keiko {

/// Shares, 0 to 1, of the projected solid angles of a row's lamps that `point` with unit `normal`
/// sees, weighed as they light: of the whole width of each lamp, which the axis alone misses by
/// 2e-3 in ordinary places and by 2 % where an occluder's edge runs along the lamp (physics 2.8).
/// `row`: parallel lamps of one diameter in a plane, in order. The axis answers where all of a lamp
/// above the horizon is proved to be seen alike, or a corner line where the axis is below it; else
/// sub-axes across the lamp, more of them until the estimated error is below `tolerance`. 1 for a
/// lamp that lights nothing of the point. `hiding`: empty, or for each lamp others of the row that
/// hide some of it; the share is of what they leave.
std::vector<double> visible_shares(std::span<const TubeLamp> row, const Vec3& point,
                                   const Vec3& normal, const Visible& visible, double tolerance,
                                   TubeShape shape = TubeShape::cylinder,
                                   std::span<const std::vector<HidingTube>> hiding = {});

} // namespace keiko
