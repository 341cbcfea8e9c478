#pragma once

#include "tests/bench/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct PenumbraOptions {
    std::vector<std::string> scenes{}; ///< names or model files; none: hood and teapot
    std::size_t points = 1000;         ///< receivers of each scene
    int width = 1280;                  ///< pixels of the pictures
    int probes = 0;                    ///< of each lamp, against the intervals; 0: none
    std::filesystem::path plot{};      ///< SVG of cost against lamps and patches; empty: none
    std::filesystem::path markdown{};  ///< page to put the tables into; empty: none
};

/// Penumbrae under a row of twelve lamps: exact intervals beside ray casting at equal error, what
/// they cost by number of lamps and of patches, and how many of them dense probing finds wrong.
struct PenumbraTables {
    Table equal_error, pictures, by_lamps, by_patches, wrong;
};
PenumbraTables run_penumbra_benchmark(const PenumbraOptions& options);

} // namespace keiko::bench
