#pragma once

#include "tests/bench/command_line.h"
#include "tests/bench/results.h"

namespace keiko::bench {

/// Traces the same rays through Keiko and its peers, one thread, in interleaved rounds. Tells
/// what it is doing on stderr. Throws Error for a scene that cannot be read.
TraceResults run_trace_benchmark(const TraceOptions& options);

} // namespace keiko::bench
