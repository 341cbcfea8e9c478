#pragma once

#include "keiko/geometry/visibility/visibility.h"

#include <vector>

namespace keiko {

/// Parameters in ]0, 1[ where a t^2 + 2 b t + c = 0, between 0 and 1, sorted.
std::vector<double> crossings(double a, double b, double c);

/// The same of the line p + t w with both nappes of the cone of `half_angle` radians about a unit
/// `axis` through 0. In components along and across the axis the terms of narrow cones do not
/// cancel.
std::vector<double> cone_crossings(const Vec3& p, const Vec3& w, const Vec3& axis,
                                   double half_angle);

} // namespace keiko
