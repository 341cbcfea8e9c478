#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/raster/triangle_scan.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// A triangle in the picture, or a part of one that was clipped.
struct ScreenItem {
    ScreenTriangle at{};        ///< its corners
    std::uint32_t triangle = 0; ///< into SurfaceMesh::triangles
};
/// Items in chunks, in the order of the mesh.
using ScreenItems = std::vector<std::vector<ScreenItem>>;

/// The triangles of a mesh that may cover the centre of a pixel. Throws Cancelled.
ScreenItems screen_items(const SurfaceMesh& mesh, const Camera& camera, const Job& job = {});

} // namespace keiko
