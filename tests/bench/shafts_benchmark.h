#pragma once

#include "tests/bench/cost_plot.h"
#include "tests/bench/table.h"

#include <string>
#include <vector>

namespace keiko::bench {

/// What light shafts of one scene cost, found and marched.
struct ShaftCost {
    std::string bodies{};
    std::size_t patches = 0;
    int lamps = 0;
    double build_seconds = 0;          ///< of what only the intervals need: silhouettes and borders
    double exact = 0, exact_error = 0; ///< microseconds a ray; mean error over mean light
    double marched = 0, marched_error = 0;
    int steps = 0; ///< in each part of a ray in a beam
    bool equi_angular = false;
    bool reached = true; ///< marching came to the error asked for
};

/// The error that both are held to, of the mean light of the rays.
constexpr double shaft_error = 1e-3;

/// The concept car under 1 to 16 lamps, then 1 to 512 spheres under four: shafts by the visible
/// intervals of each ray beside marching with Keiko's own tracer, spaced and stepped as is cheapest
/// for the same error. Processor time of one thread.
std::vector<ShaftCost> run_shafts_benchmark(std::size_t marched_rays);

Table shafts_table(const std::vector<ShaftCost>& costs);
/// Cost over the number of lamps, and over that of patches.
std::vector<CostPanel> shafts_panels(const std::vector<ShaftCost>& costs);

} // namespace keiko::bench
