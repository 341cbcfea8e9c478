#pragma once

#include "keiko/io/load_model.h"
#include "keiko/io/model_format.h"

namespace keiko {

/// Has the worker executable read a CAD file. Throws as load_model does.
SurfaceModel import_in_worker(const std::filesystem::path& path, ModelFormat format,
                              const LoadOptions& options, const Job& job);

} // namespace keiko
