#pragma once

#include "keiko/base/units.h"

#include <cmath>

namespace keiko {

/// G3 as an angle, in degrees: between the tangents of the plots of the radius of curvature over
/// arc length on the two sides of a seam, tan = R' = -k' / k^2. It does not change with the size
/// of the part. `k` in 1/mm, `slope` = k' in 1/mm2. CATIA, which states G3 in degrees, does not
/// print its formula; this is Keiko's reading.
inline double slope_angle(double k1, double slope1, double k2, double slope2) {
    const double first = std::atan2(slope1, k1 * k1), second = std::atan2(slope2, k2 * k2);
    return radians_to_degrees(std::abs(first - second));
}

} // namespace keiko
