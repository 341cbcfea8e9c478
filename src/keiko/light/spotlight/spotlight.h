#pragma once

#include "keiko/light/spotlight/beam_pattern.h"
#include "keiko/light/spotlight/beam_profile.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <optional>

namespace keiko {

/// A spotlight without extent.
struct Spotlight {
    Vec3 position{0};       ///< mm
    Vec3 aim{0, 0, -1};     ///< a point on the axis, mm
    double half_angle = 20; ///< degrees from the axis to the rim
    BeamProfile profile{};  ///< over theta, and phi where it is a table; 0 beyond the rim
    Rgb intensity{1000};    ///< cd where the profile is 1, colour included
    Vec3 reference{1, 0,
                   0}; ///< direction of phi = 0, of any length; its part along the axis is dropped
    double spin = 0;   ///< degrees added to phi
    /// Degrees, of an elliptic beam: from the axis to the rim under phi = 90 degrees, while
    /// half_angle is that under 0; both below 90.
    std::optional<double> half_angle_across{};
    BeamPattern pattern{};
    bool hue = false;  ///< the colour goes around the circle of hues with phi
    bool shaft = true; ///< it lights the medium
};

} // namespace keiko
