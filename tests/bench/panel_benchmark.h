#pragma once

#include "tests/bench/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keiko::bench {

struct PanelOptions {
    std::vector<std::string> scenes{}; ///< names or model files; none: hood and concept-car
    std::size_t points = 1000;         ///< receivers of each scene
    int width = 960;                   ///< pixels of the pictures
    std::filesystem::path markdown{};  ///< page to put the table into; empty: none
};

/// Pictures of a body with panels behind it at an error of 1e-3, beside stratified Monte Carlo
/// sampling of the panels' areas at their pixels.
Table run_panel_benchmark(const PanelOptions& options);

} // namespace keiko::bench
