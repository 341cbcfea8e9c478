#pragma once

#include "keiko/spotlight/spotlight.h"

namespace keiko {

/// 1 - cos of the angle between two unit vectors, without cancellation for narrow beams.
inline double versine(const Vec3& a, const Vec3& b) {
    return (a - b).length2() / 2;
}

/// Unit vector along the beam; NaN, which lights nothing, where aim and position coincide.
inline Vec3 beam_axis(const Spotlight& light) {
    const Vec3 axis = light.aim - light.position;
    return axis / axis.length();
}

/// Versine of the beam's half angle, 0 to 2.
double rim_versine(const Spotlight& light);

/// Intensity over that on the axis, 0 to 1, at 1 - cos theta = `versine`: [000] eqs (4) to (6),
/// 0 beyond the rim (physics 7.2).
double relative_intensity(const Spotlight& light, double versine);

/// Intensity in cd towards a point in mm; 0 at the lamp itself.
Rgb intensity_towards(const Spotlight& light, const Vec3& point);

/// Luminous flux of the lamp in lm, by channel.
Rgb luminous_flux(const Spotlight& light);

/// Illuminance in lx at a `point` that sees the lamp, on a surface with unit `normal`; 0 from
/// behind (eq. (7.1)).
Rgb illuminance(const Spotlight& light, const Vec3& point, const Vec3& normal);

} // namespace keiko
