#pragma once

#include "keiko/math/bounds.h"

#include "tests/bench/contender.h"

#include <algorithm>

namespace keiko::bench {

/// When a contender's hit counts as the same place as the truth, mm.
struct PlaceTolerance {
    double off_plane = 0; ///< from the true tangent plane
    double along_ray = 0; ///< from the true hit: a grazing ray stays near its plane for long
};

inline PlaceTolerance place_tolerance(const ContenderFacts& facts, const Box3& bounds) {
    return {std::max(4 * std::max(facts.deflection, facts.deviation), 1e-4 * bounds.size()),
            1e-2 * bounds.size()};
}

} // namespace keiko::bench
