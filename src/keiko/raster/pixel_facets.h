#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// Facets of a surface as a camera sees it, one a pixel.
struct PixelFacets {
    SurfaceMesh mesh; ///< a triangle for each pixel that shows the surface; SurfaceMesh::deviation
                      ///< is not known and 0
    ItemBuffer items; ///< the triangle of each pixel
};

/// Facets of the pieces that recursive subdivision shows [Catmull1974], see subdivided_pieces():
/// each as large as half of its piece, around the place that the pixel's centre shows. Corners lie
/// on the exact surface and have its normals, outward; 0 where there are none. Weights must be
/// positive. The same for any number of threads. Throws Cancelled.
PixelFacets pixel_facets(const SurfaceModel& model, const Camera& camera, const Job& job = {});

} // namespace keiko
