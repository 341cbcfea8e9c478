#pragma once

#include "keiko/math/vec.h"

#include <span>

namespace keiko {

/// Integral of (a.w)(b.w) over the unit directions w from the origin to a planar polygon: the
/// irradiance tensor of second order [Arvo1995], contracted with two vectors
/// (docs/theory/sky.md#closed-forms). Corners are in either order, in any unit of length, and none
/// is at the origin. The polygon may be concave; it is 0 for one viewed edge-on.
double second_irradiance_moment(std::span<const Vec3> corners, const Vec3& a, const Vec3& b);

} // namespace keiko
