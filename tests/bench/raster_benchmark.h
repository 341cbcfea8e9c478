#pragma once

#include "tests/bench/table.h"

#include <filesystem>

namespace keiko::bench {

struct RasterOptions {
    double deviation = 0.1;           ///< mm, of the mesh
    int width = 1920;                 ///< of the picture, px
    std::filesystem::path markdown{}; ///< page to put the table into; empty: none
};

/// Times of the algorithms that find the visible triangles of the concept car's mesh, which is that
/// of the spans: OpenCASCADE would take a minute.
Table run_raster_benchmark(const RasterOptions& options);

} // namespace keiko::bench
