#pragma once

#include "keiko/base/job.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace keiko {

/// Calls `body(0) .. body(count - 1)`, each once, on the threads of `job`, reporting progress
/// as `stage` (empty: none). Deterministic as long as each call writes only what belongs to its
/// index: make an index a tile or a chunk, not a pixel. The first exception is rethrown;
/// throws Cancelled when the job is stopped.
void parallel_for(std::size_t count, const Job& job, std::string_view stage,
                  const std::function<void(std::size_t)>& body);

} // namespace keiko
