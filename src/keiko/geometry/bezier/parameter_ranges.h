#pragma once

#include "keiko/geometry/bezier/parameter_map.h"
#include "keiko/math/interval.h"

namespace keiko {

/// Ranges of a map's first and second derivatives over a range of its patch's parameter.
struct ParameterRanges {
    Interval first, second;
};
ParameterRanges parameter_ranges(const ParameterMap& map, const Interval& t);

} // namespace keiko
