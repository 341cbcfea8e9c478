#pragma once

#include "keiko/inspect/seams/seam_measure.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// Distances over which a line goes on from one stretch to the next.
struct LineReach {
    double join = 0.5;      ///< mm, between ends at one corner of patches
    double out_of_step = 0; ///< mm, between ends where rows of patches are out of step
};

/// Pairs of stretches: one goes on, within 30 degrees, where the other ends. Ends that
/// nothing meets go on at the nearest such end within reach, but at most a twentieth of the shorter
/// stretch away.
std::vector<std::array<std::size_t, 2>> continuations(
    std::span<const MeasuredSeam* const> stretches, const LineReach& reach);

} // namespace keiko
