#pragma once

#include "keiko/math/interval_set.h"
#include "keiko/tubes/tube_lamp.h"

namespace keiko {

/// How a lamp is taken for what it is not, from the seed paper to exact (physics 2). Errors are
/// those of a lamp in ordinary position, by d/D, its diameter over its distance.
enum class TubeModel {
    automatic, ///< strip up to d/D = 0.04, where its error is 1e-4; cylinder beyond
    picture,   ///< strip up to d/D = 0.2, where its error is 2.3e-3; cylinder beyond
    seed,      ///< [003] eq. (1) with its indices corrected (2.1): -0.27 d/D
    rectangle, ///< the facing rectangle, exactly (2.2): -0.27 d/D
    line,      ///< the limit of a thin lamp (2.4): -0.26 d/D
    strip,     ///< mean-rim strip (2.3): -0.058 (d/D)^2
    cylinder   ///< the tube itself by quadrature (2.5): below 1e-9
};

/// Projected solid angle in sr of what `point` with unit `normal` sees of the lateral surface of
/// a lamp: the illuminance in lx for a luminance of 1 cd/m2. `visible` holds the parts of the axis
/// that are not hidden, parameters 0 (end a) to 1 (end b); the tangent plane clips by itself. 0
/// inside the glass and on the line of the axis.
double projected_solid_angle(const TubeLamp& lamp, const Vec3& point, const Vec3& normal,
                             const IntervalSet& visible = IntervalSet::whole(),
                             TubeModel model = TubeModel::automatic);

/// Illuminance in lx: the same times the lamp's luminance. Lamps that hide each other are not
/// accounted for: at grazing angles to their plane the sum over lamps is too bright.
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
