#pragma once

#include "tests/bench/results.h"

#include <filesystem>

namespace keiko::bench {

/// All numbers, with SI units and rays per second. Throws Error when the file cannot be written.
void write_json(const std::filesystem::path& file, const TraceResults& results);

} // namespace keiko::bench
