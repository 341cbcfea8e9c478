#pragma once

#include "tests/bench/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct InspectBenchmarkOptions {
    std::vector<std::string> files{}; ///< model files; none: those of the tracked table
    std::filesystem::path rig{};      ///< of every file; empty: lamps are placed
    std::filesystem::path markdown{}; ///< page to put the table into; empty: none
};

/// Processor time of `keiko inspect FILE` with its defaults, whole and by stage, in units of what
/// OpenCASCADE takes in the same run to mesh surfaces/concept-car.step at 0.1 mm. Files that are
/// not there are left out.
Table run_inspect_benchmark(const InspectBenchmarkOptions& options);

} // namespace keiko::bench
