#pragma once

#include "keiko/volumes/voxel_grid.h"

#include <vector>

namespace keiko {

/// Points in which the surface of one value crosses the lines between neighbouring nodes, in steps
/// between nodes: along x first, then y and z, each in the order of the nodes. They are exact for
/// the trilinear grid.
std::vector<Vec3> iso_points(const VoxelGrid& grid, double value);

} // namespace keiko
