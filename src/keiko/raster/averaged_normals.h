#pragma once

#include "keiko/geometry/model/surface_mesh.h"

#include <vector>

namespace keiko {

/// Unit normals at the corners of a mesh as the mean of those of the triangles around them, by
/// their areas [Gouraud1971], averaged within each face: corners of one face at one place are one.
/// 0 where the triangles have no area.
std::vector<Vec3> averaged_normals(const SurfaceMesh& mesh);

} // namespace keiko
