#pragma once

#include "keiko/math/vec.h"
#include "keiko/raster/mesh_shadows.h"

#include <span>
#include <vector>

namespace keiko {

/// Points that stand for the side of a plane polygon from which its corners run anticlockwise. Its
/// ears are cut off one by one [Meisters1975], and the edges of these triangles divided into
/// `parts`; points are the middles of the equal triangles between. All areas are above 0 and sum to
/// the polygon's, in mm2. `corners`: convex or not, without crossings.
std::vector<EmittingPoint> points_of_panel(std::span<const Vec3> corners, int parts);

} // namespace keiko
