#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// Piece of a placed patch that a pixel shows.
struct PatchPiece {
    std::uint32_t instance = no_index; ///< into SurfaceModel::instances; no_index: nothing is shown
    std::uint32_t patch = 0;           ///< into SurfaceModel::patches
    Box2 uv = unit_square;             ///< its parameters of the patch
};

/// Pieces that the pixels show, row by row, by recursive subdivision of the exact patches
/// [Catmull1974]. Pieces are halved until they are a pixel wide and hold one centre, whose depth
/// they then have. No mesh is made. At outlines and borders a pixel may be wrong. Weights must be
/// positive. The same for any number of threads. Throws Cancelled.
std::vector<PatchPiece> subdivided_pieces(const SurfaceModel& model, const Camera& camera,
                                          const Job& job = {});

/// Faces of these pieces, indices into SurfaceModel::faces.
ItemBuffer subdivided_faces(const SurfaceModel& model, const Camera& camera, const Job& job = {});

} // namespace keiko
