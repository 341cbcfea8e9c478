#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// Faces that the pixels show, indices into SurfaceModel::faces, by recursive subdivision of the
/// exact patches [Catmull1974]. Pieces are halved until they are a pixel wide and hold one centre,
/// whose depth they then have. No mesh is made. At outlines and borders a pixel may be wrong.
/// Weights must be positive. The same for any number of threads. Throws Cancelled.
ItemBuffer subdivided_faces(const SurfaceModel& model, const Camera& camera, const Job& job = {});

} // namespace keiko
