#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// The triangles of z_buffer() by scan lines [Sutherland1974]: the spans of a row are sorted from
/// left to right, and only where they overlap are depths compared. Triangles stay in the list from
/// row to row, and so does its order, nearly. They differ from z_buffer()'s only where depths agree
/// to rounding. The same for any number of threads. Throws Cancelled.
ItemBuffer scan_line(const SurfaceMesh& mesh, const Camera& camera, const Job& job = {});

} // namespace keiko
