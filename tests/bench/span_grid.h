#pragma once

#include "keiko/geometry/model/surface_model.h"

#include "tests/bench/triangle_mesh.h"

namespace keiko::bench {

/// Every placed patch as a grid of n x n cells of two triangles with the surface's own normals at
/// the vertices; cells whose centre is trimmed away are left out.
TriangleMesh span_grid(const SurfaceModel& model, int n, const Vec3& center);

/// The largest n with at most `most_triangles` triangles, trims not counted; 0 where there is none.
int finest_span_grid(const SurfaceModel& model, std::size_t most_triangles);

} // namespace keiko::bench
