#pragma once

#include "keiko/files/model/model_format.h"
#include "keiko/import/worker/load_model.h"

namespace keiko {

/// The worker executable that the options ask for.
std::filesystem::path worker_path(const LoadOptions& options);

/// Has the worker executable read a CAD file or a cage; it answers as WorkerAnswer says. Throws as
/// load_model does.
SurfaceModel import_in_worker(const std::filesystem::path& path, ModelFormat format,
                              const LoadOptions& options, const Job& job);

} // namespace keiko
