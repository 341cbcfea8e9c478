#pragma once

#include "tests/bench/table.h"

#include <filesystem>

namespace keiko::bench {

struct FrameOptions {
    int width = 1920;                 ///< px, at 16:9
    std::filesystem::path markdown{}; ///< page to put the table into; empty: none
};

/// Cost of pictures of the concept car under twelve lamps after loading, on all cores: its stripes
/// alone, and all light with penumbrae.
Table run_frame_benchmark(const FrameOptions& options);

} // namespace keiko::bench
