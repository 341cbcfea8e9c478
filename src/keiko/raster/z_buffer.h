#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// The nearest triangle of a mesh at each pixel's centre, by a z-buffer in tiles [Catmull1974].
/// Both sides of triangles are seen. Of triangles at one depth the first of the mesh counts. The
/// same result for any number of threads. Throws Cancelled.
ItemBuffer z_buffer(const SurfaceMesh& mesh, const Camera& camera, const Job& job = {});

} // namespace keiko
