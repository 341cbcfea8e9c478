#pragma once

#include "keiko/light/spotlight/spotlight.h"

namespace keiko {

/// Unit vector along the beam; NaN, which lights nothing, where aim and position coincide.
inline Vec3 beam_axis(const Spotlight& light) {
    const Vec3 axis = light.aim - light.position;
    return axis / axis.length();
}

/// A spotlight made ready to be asked for its intensity into many directions; keeps a reference
/// to it.
class BeamIntensity {
public:
    explicit BeamIntensity(const Spotlight& light);

    /// cd towards a point in mm; 0 at the lamp itself.
    Rgb operator()(const Vec3& point) const;
    /// cd into a direction of the lamp's own frame.
    Rgb towards(const BeamDirection& direction) const;
    const BeamFrame& frame() const { return frame_; }
    /// Versine of the half angle at an angle phi in radians, without spin: 0 to 2.
    double rim(double phi) const;

private:
    const Spotlight& light_;
    BeamFrame frame_;
    double rim_;
};

/// Intensity in cd towards a point in mm; 0 at the lamp itself.
Rgb intensity_towards(const Spotlight& light, const Vec3& point);

} // namespace keiko
