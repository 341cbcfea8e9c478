#pragma once

#include "keiko/import/worker/load_model.h"

#include <string>
#include <vector>

namespace keiko {

/// Libraries that the worker reads with, each with its version: "OpenCASCADE 7.6.3". Throws Error
/// when the worker is missing or does not answer.
std::vector<std::string> worker_libraries(const LoadOptions& options);

} // namespace keiko
