#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/model_mesh.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/triangle_limit.h"

namespace keiko {

/// Triangles of the material of each face: every patch, a knot span, in a grid of cells of two
/// triangles that no place of the surface leaves by more than `deviation` mm, which is proved.
/// Patches side by side have as many cells along their common side. Cells that trim curves cross
/// are cut along chords. On the surface, no trim curve within the cell is farther from its chord
/// than `deviation`, which is proved too; trims within a millionth of a patch of its border count
/// as on it. Islands and holes smaller than `deviation` may be lost. FaceMesh::deviation is the
/// larger of both bounds. The weights of the model must be positive. Throws Error naming the
/// model's source for more cells or triangles than the limit, before memory is spent on more;
/// Cancelled.
ModelMesh span_mesh(const SurfaceModel& model, double deviation, const Job& job = {},
                    const TriangleLimit& limit = {});

} // namespace keiko
