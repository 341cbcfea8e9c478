#pragma once

#include "keiko/geometry/model/surface_model.h"

#include "tests/bench/ray_set.h"

#include <array>

namespace keiko::bench {

/// Costs of the tests of a ray against a sub-patch in one mode, in cycles of the processor's
/// time-stamp counter: medians over the rounds.
struct KernelCosts {
    double look = 0;  ///< cycles, the first look of one ray at one sub-patch
    double solve = 0; ///< cycles, one root with its bound
    double proof = 0; ///< share of the search for t and uv that is left out without proofs
};

/// In Mode::single and Mode::packets.
using CostsByMode = std::array<KernelCosts, 2>;

CostsByMode kernel_costs(const SurfaceModel& model, const RaySet& rays, int rounds);

} // namespace keiko::bench
