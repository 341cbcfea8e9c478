#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// The triangles of z_buffer() by priority: in each tile they are painted from the back to the
/// front, so that no depth is kept. Their order is that of a tree of their planes [Fuchs1980];
/// triangles that a plane cuts are painted in two parts. They differ from z_buffer()'s only where
/// depths agree to rounding. The same for any number of threads. Throws Cancelled.
ItemBuffer painted_triangles(const SurfaceMesh& mesh, const Camera& camera, const Job& job = {});

} // namespace keiko
