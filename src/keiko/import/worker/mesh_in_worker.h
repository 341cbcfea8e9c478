#pragma once

#include "keiko/geometry/model/model_mesh.h"
#include "keiko/import/worker/load_model.h"

namespace keiko {

/// Triangles of the material of each face of a model, which leave the exact surface by about
/// `deviation` mm; FaceMesh::deviation has the measured number. The worker process of load_model
/// makes them, with OpenCASCADE's mesher. A face that it makes none of has a problem. Throws Error
/// naming the model's source as load_model does, Cancelled.
ModelMesh mesh_in_worker(const SurfaceModel& model, double deviation,
                         const LoadOptions& options = {}, const Job& job = {});

} // namespace keiko
