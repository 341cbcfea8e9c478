#pragma once

#include "tests/bench/penumbra_methods.h"

#include <algorithm>
#include <vector>

namespace keiko::bench {

/// The faster of some runs: what else the machine does only ever adds.
template <class Method>
Shares fastest(const Method& method) {
    constexpr int rounds = 3;
    Shares best = method();
    for (int i = 1; i < rounds; ++i) best.seconds = std::min(best.seconds, method().seconds);
    return best;
}

/// Microseconds a receiver.
double us_a_point(const Shares& shares);

/// Cost of a method at the error that it was found to have.
struct Cost {
    double rays = 0; ///< a lamp
    double error = 0, us = 0;
};

/// Cost of a method at an error that may need more rays than were traced. It follows power laws
/// through the larger half of the numbers of rays.
Cost cost_at(const std::vector<Cost>& measured, double error);

/// Cost of the cheapest of several ladders of numbers of rays at an error.
Cost best_sampling(const std::vector<std::vector<Cost>>& ladders, double error);

} // namespace keiko::bench
