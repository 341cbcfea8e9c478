#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace keiko {

/// How the intensity falls off towards the rim of the beam ([000] eqs (4) to (6)).
enum class BeamEdge { sharp, soft, mixed };

/// A spotlight without extent.
struct Spotlight {
    Vec3 position{0};       ///< mm
    Vec3 aim{0, 0, -1};     ///< a point on the axis, mm
    double half_angle = 20; ///< degrees from the axis to the rim
    BeamEdge edge = BeamEdge::soft;
    double q = 0.5;      ///< share of the sharp edge where the edge is mixed
    Rgb intensity{1000}; ///< cd at theta = 0, colour included
};

} // namespace keiko
