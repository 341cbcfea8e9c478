#pragma once

#include "keiko/math/vec.h"

#include <span>
#include <vector>

namespace keiko {

/// Direct exchange area in mm2 of two convex plane polygons with nothing between them
/// [Sparrow1963]. It is the area of the first times its form factor to the second, and the same
/// from the second to the first. It counts what lies before the face of the other from which the
/// corners run anticlockwise. Polygons may touch along edges and corners, not cross. 0 for fewer
/// than three corners. The error is at most 1e-10 of the smaller area (docs/theory/radiosity.md).
double direct_exchange_area(std::span<const Vec3> first, std::span<const Vec3> second);

/// The part of a convex polygon on the side of a plane through `place` that `normal` points to;
/// empty if there is none.
std::vector<Vec3> part_before(std::span<const Vec3> corners, const Vec3& place, const Vec3& normal);

} // namespace keiko
