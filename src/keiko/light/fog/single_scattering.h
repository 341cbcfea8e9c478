#pragma once

#include "keiko/light/fog/transmittance.h"

#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// Integral of exp(-u tan xi) over xi from `begin` to `end`, within 0 to pi/2, u >= 0: the airlight
/// of an isotropic point source along a ray in a uniform medium [Sun2005]
/// (docs/theory/fog.md#the-integral). It is computed in closed form, by the exponential integral of
/// complex numbers, to 1e-13 of the width.
double airlight(double u, double begin, double end);

/// A point source viewed from the medium along one ray.
struct PointEmitter {
    Vec3 position{0};                                ///< mm
    std::function<Rgb(const Vec3& point)> intensity; ///< cd towards a point in mm
    std::optional<Rgb> even{};                       ///< cd, if it is uniform over the beam
    /// Parameters of the ray, rising, at which the intensity has a kink.
    std::vector<double> kinks{};
};

/// Relative error allowed in the scattered light of a ray that is reported as a number.
constexpr double scattering_tolerance = 1e-8;
/// Relative error allowed in the scattered light of a picture's rays.
constexpr double picture_scattering_tolerance = 1e-5;

/// Luminance in cd/m2 that light of the emitter adds at the camera. The light is scattered once in
/// the `lit` parts of a camera ray (from the eye at a to b, parameters 0 to 1) and attenuated on
/// both legs. The rule is equi-angular Gauss quadrature (docs/theory/fog.md#the-integral) between
/// the kinks of the intensity and of the density, refined until `tolerance` of the whole is
/// estimated. `airlight` replaces it if emitter, medium and phase are uniform, and so does the
/// medium's own rule. A ray that passes the emitter within 5 mm is placed at 5 mm, the lamp's own
/// size: the integral has no limit there.
Rgb scattered_light(const AttenuatedRay& camera_ray, const IntervalSet& lit,
                    const PointEmitter& emitter, double tolerance = scattering_tolerance);

} // namespace keiko
