#pragma once

#include "tests/bench/results.h"
#include "tests/bench/table.h"

namespace keiko::bench {

/// The design's targets, row by row, beside what was measured: the median over the scenes that a
/// row is about, and the least and the most.
Table target_table(const TraceResults& results);

} // namespace keiko::bench
