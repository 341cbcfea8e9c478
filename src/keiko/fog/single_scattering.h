#pragma once

#include "keiko/fog/medium.h"
#include "keiko/luminance/visible.h"

#include <functional>

namespace keiko {

/// A point source as the medium sees it.
struct PointEmitter {
    Vec3 position{0};                                ///< mm
    std::function<Rgb(const Vec3& point)> intensity; ///< cd towards a point in mm
};

/// Luminance in cd/m2 that light of the emitter, scattered once in the `lit` parts of an eye ray
/// (from the eye at a to b, parameters 0 to 1), adds at the eye; attenuated on both legs.
/// Equi-angular Gauss quadrature (physics 8.5, eq. (8.1)) refined to 1e-8 where the intensity is
/// smooth. A ray that runs closer than 5 mm past the emitter is taken at 5 mm, the lamp's own
/// size: the integral has no limit there.
Rgb scattered_light(const Medium& medium, const Segment& eye_ray, const IntervalSet& lit,
                    const PointEmitter& emitter);

} // namespace keiko
