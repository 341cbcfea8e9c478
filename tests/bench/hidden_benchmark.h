#pragma once

#include "tests/bench/log_plot.h"
#include "tests/bench/table.h"

#include <filesystem>
#include <vector>

namespace keiko::bench {

struct HiddenOptions {
    std::filesystem::path plot{};     ///< SVG of cost and memory; empty: none
    std::filesystem::path markdown{}; ///< page to put the tables into; empty: none
    bool brief = false;               ///< smallest sizes alone: whether it runs
};

/// Cost of one algorithm for one scene and picture.
struct HiddenCost {
    std::size_t triangles = 0;
    int side = 0;          ///< pixels along an edge of the picture
    double seconds = 0;    ///< processor time of one thread, the least of three rounds
    double bytes = 0;      ///< of the heap at the most, its result included
    std::size_t wrong = 0; ///< pixels off edges of spheres that show another one
};

/// Costs of one algorithm, over triangles and over pixels.
struct HiddenSeries {
    const char* name;
    const char* kind; ///< its class by [Sutherland1974]
    std::vector<HiddenCost> over_triangles{}, over_pixels{};
};

/// Algorithms of the three classes on spheres that pierce each other.
std::vector<HiddenSeries> run_hidden_benchmark(const HiddenOptions& options);

/// Costs of the middle scene, and the powers of triangles and of pixels that costs grow with.
Table hidden_table(const std::vector<HiddenSeries>& series);
/// Seconds and bytes over triangles and over pixels.
std::vector<LogPlot> hidden_plots(const std::vector<HiddenSeries>& series);

} // namespace keiko::bench
