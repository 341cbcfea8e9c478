#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

namespace KEIKO_API keiko {

/// Distribution of a point source's intensity by the angle theta to its axis.
enum class PointDistribution {
    uniform,  ///< 1 in all directions
    cardioid, ///< (1 + cos theta) / 2: a bulb whose base is dark [Nishita1985]
    power     ///< cos^c theta, 0 beyond 90 degrees
};

/// A bare lamp without extent.
struct PointSource {
    Vec3 position{0};    ///< mm
    Vec3 axis{0, 0, -1}; ///< direction of theta = 0, of any length but 0
    PointDistribution distribution = PointDistribution::uniform; ///< of the intensity
    double exponent = 1;                                         ///< the power c, 0 or more
    Rgb intensity{1000}; ///< cd along the axis, colour included
    bool shaft = true;   ///< it lights the medium

    bool operator==(const PointSource&) const = default;
};

/// Intensity in cd towards a point in mm; 0 at the lamp itself.
Rgb intensity_towards(const PointSource& light, const Vec3& point);

/// Parts of a segment that the lamp sends light to, parameters 0 to 1: those before the lamp for a
/// power of the cosine.
IntervalSet in_beam(const PointSource& light, const Segment& segment);

/// Luminous flux in lm of a lamp of the same distribution with an intensity of 1 cd along the axis.
double flux_of_unit_intensity(const PointSource& light);

} // namespace keiko
