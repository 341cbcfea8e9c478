#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace KEIKO_API keiko {

/// Calls `body` for each index below `count`, once, on the threads of `job`, reporting progress as
/// `stage` (empty: none). Deterministic as long as each call writes only what belongs to its index:
/// make an index a tile or a chunk, not a pixel. The first exception is rethrown; throws Cancelled
/// when the job is stopped.
void parallel_for(std::size_t count, const Job& job, std::string_view stage,
                  const std::function<void(std::size_t)>& body);

/// Stages of parallel_stream for each of its slots, buffers that the caller owns.
struct StreamStages {
    std::function<bool(std::size_t slot)> read;  ///< fills it; false: there is no more
    std::function<void(std::size_t slot)> work;  ///< on any thread, several at once
    std::function<bool(std::size_t slot)> write; ///< in the order of reading; false: enough
};

/// Streams through `slots` buffers: reads one, works on it while others are read, writes it before
/// it is read again, so that memory stays constant however long the stream is. Reading and writing
/// never overlap themselves. The first exception is rethrown; throws Cancelled when the job is
/// stopped.
void parallel_stream(std::size_t slots, const Job& job, const StreamStages& stages);

/// Number of threads that `job` gets.
std::size_t thread_count(const Job& job);

} // namespace keiko
