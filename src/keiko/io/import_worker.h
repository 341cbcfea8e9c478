#pragma once

#include "keiko/io/load_model.h"
#include "keiko/io/model_format.h"

namespace keiko {

/// The worker executable that the options ask for.
std::filesystem::path worker_path(const LoadOptions& options);

/// Has the worker executable read a CAD file or a cage; it answers as WorkerAnswer says. Throws as
/// load_model does.
SurfaceModel import_in_worker(const std::filesystem::path& path, ModelFormat format,
                              const LoadOptions& options, const Job& job);

} // namespace keiko
