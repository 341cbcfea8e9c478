#pragma once

#include "keiko/math/nearest_rank.h"

#include <utility>
#include <vector>

namespace keiko::bench {

/// The middle one of some values, NaN of none.
inline double median(std::vector<double> values) {
    return nearest_rank(std::move(values), 0.5);
}

} // namespace keiko::bench
