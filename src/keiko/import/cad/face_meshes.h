#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/model_mesh.h"
#include "keiko/geometry/model/surface_model.h"

namespace keiko::cad {

/// Triangles of the material of each face, by OpenCASCADE's mesher on the exact surface and its own
/// p-curves. Each face is meshed by itself: two faces at a seam have corners of their own. A face
/// whose triangles leave the surface by more than `deviation` mm is meshed anew, more finely, up to
/// five times; what is left stands in its mesh. Reports stage "mesh".
ModelMesh mesh_faces(const SurfaceModel& model, double deviation, const Job& job = {});

} // namespace keiko::cad
