#pragma once

#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/light/tubes/tube_model.h"
#include "keiko/math/interval_set.h"

namespace keiko {

/// Projected solid angle in sr of what `point` with unit `normal` sees of the lateral surface of
/// a lamp, and of its cap if that shines: the illuminance in lx for a luminance of 1 cd/m2.
/// `visible` holds the parts of the axis that are not hidden, parameters 0 (end a) to 1 (end b); a
/// cap is seen where its end is. The tangent plane clips by itself. 0 inside the glass; on the line
/// of the axis only a cap is seen.
double projected_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                             const IntervalSet& visible = IntervalSet::whole(),
                             TubeModel model = TubeModel::automatic);

/// Of the same, what the cap that faces the point gives; 0 where caps are dark.
double cap_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                       const IntervalSet& visible = IntervalSet::whole());

/// Illuminance in lx: the same times the lamp's luminance. What other lamps hide of it is not
/// accounted for: comb_solid_angle does.
inline Rgb irradiance(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                      const IntervalSet& visible = IntervalSet::whole(),
                      TubeModel model = TubeModel::automatic) {
    return lamp.luminance * projected_solid_angle(lamp, point, normal, visible, model);
}

/// Whether the whole lamp lies below the tangent plane, so that nobody need ask what hides it.
inline bool below_horizon(const TubeLamp& lamp, const Vec3& point, const Vec3& normal) {
    const double radius = lamp.diameter / 2;
    return normal.dot(lamp.a - point) <= -radius && normal.dot(lamp.b - point) <= -radius;
}

} // namespace keiko
