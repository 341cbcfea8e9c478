#pragma once

#include "keiko/io/load_model.h"
#include "keiko/io/model_format.h"

namespace keiko {

/// Has the worker executable read a CAD file. What the worker writes: lines "progress FRACTION",
/// then either "error REASON" or "model" and the serialised model. Throws as load_model does.
SurfaceModel import_in_worker(const std::filesystem::path& path, ModelFormat format,
                              const LoadOptions& options, const Job& job);

} // namespace keiko
