#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/tubes/tube_lamp.h"

namespace keiko {

/// What of a lamp's width faces the point: the tube itself, or the rectangle through its axis.
enum class TubeShape { cylinder, rectangle };

/// Share, 0 to 1, of a lamp's projected solid angle that `point` with unit `normal` sees, weighed
/// as it lights: the whole width of the lamp, which the axis alone misses by 2e-3 in ordinary
/// places and by 2 % where an occluder's edge runs along the lamp (physics 2.8). Sub-axes across
/// the lamp are asked for, more of them until the estimated error is below `tolerance`. 1 for a
/// lamp that lights nothing of the point.
double visible_share(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                     const Visible& visible, double tolerance,
                     TubeShape shape = TubeShape::cylinder);

} // namespace keiko
