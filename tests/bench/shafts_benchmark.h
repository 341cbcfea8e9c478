#pragma once

#include "tests/bench/log_plot.h"
#include "tests/bench/table.h"

#include <string>
#include <vector>

namespace keiko::bench {

/// How far the light of rays is from its true value.
struct ShaftError {
    double mean = 0; ///< mean of the differences over the mean light
    double rms = 0;  ///< root of their mean square, over the mean light
    /// Share of its own light (or of a twentieth of the mean light, where that is more) by which
    /// all rays but one in a hundred are off at most.
    double most_rays = 0;
};

/// Marching with the fewest steps that reach an error.
struct MarchingCost {
    double microseconds = 0; ///< a ray
    int steps = 0;           ///< in each part of a ray in a beam
    bool equi_angular = false, reached = false;
};

/// Cost of the light shafts of one scene, found and marched.
struct ShaftCost {
    std::string bodies{};
    std::size_t patches = 0;
    int lamps = 0;
    double build_seconds = 0;  ///< of what only the intervals need: silhouettes and borders
    double pencil_seconds = 0; ///< of what a light sees edge-on, a light, once a picture
    double exact = 0;          ///< microseconds a ray, with its share of that
    ShaftError exact_error{};
    MarchingCost to_mean{}, to_rms{}, to_most_rays{}; ///< until that error is shaft_error
};

/// The error that both are held to.
constexpr double shaft_error = 1e-3;

/// Costs for the concept car under 1 to 16 lamps, then for 4 to 512 spheres under four. Shafts by
/// the visible intervals of each ray stand beside marching with Keiko's own tracer, spaced and
/// stepped as is cheapest for the same error. Processor time of one thread.
std::vector<ShaftCost> run_shafts_benchmark(std::size_t marched_rays);

Table shafts_table(const std::vector<ShaftCost>& costs);
/// Cost over the number of lamps, and over that of patches.
std::vector<LogPlot> shafts_plots(const std::vector<ShaftCost>& costs);

} // namespace keiko::bench
