#pragma once

#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/math/interval_set.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

#include <vector>

namespace keiko::bench {

/// The visible parts of the three edges of each triangle, from its first corner on, each edge
/// against every triangle [Roberts1963]: the class of object space, whose cost grows with n^2 and
/// knows no pixels.
std::vector<IntervalSet> visible_edges(const SurfaceMesh& mesh, const Camera& camera);

/// The nearest triangle of each pixel, by its ray against every triangle: the class of image space
/// without any coherence, whose cost grows with n N^2.
ItemBuffer cast_triangles(const SurfaceMesh& mesh, const Camera& camera);

} // namespace keiko::bench
