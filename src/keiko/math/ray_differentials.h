#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

namespace KEIKO_API keiko {

/// Change of a ray with the picture's x and y, per pixel: derivatives of its origin (mm) and of its
/// direction [Igehy1999].
template <class Real>
struct RayDifferentialsT {
    Vec3T<Real> origin_dx{0}, origin_dy{0};       ///< change of the origin, mm a pixel
    Vec3T<Real> direction_dx{0}, direction_dy{0}; ///< change of the direction, a pixel

    /// Differentials for a pixel of `factor` times the width and height.
    RayDifferentialsT scaled(double factor) const {
        return {origin_dx * factor, origin_dy * factor, direction_dx * factor,
                direction_dy * factor};
    }
};
/// For one ray.
using RayDifferentials = RayDifferentialsT<double>;

} // namespace keiko
