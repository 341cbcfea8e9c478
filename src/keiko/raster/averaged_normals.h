#pragma once

#include "keiko/geometry/model/surface_mesh.h"

#include <vector>

namespace keiko {

/// Unit normals at the corners of a mesh as the mean of those of the triangles around them, by
/// their areas [Gouraud1971]. They are averaged within each face, where corners at one place are
/// one. 0 where the triangles have no area.
std::vector<Vec3> averaged_normals(const SurfaceMesh& mesh);

} // namespace keiko
