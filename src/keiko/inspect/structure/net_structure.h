#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/structure/span_nets.h"

#include <optional>
#include <vector>

namespace keiko {

// Order and evenness of the control points of a face's knot spans (docs/theory/structure.md). Rows
// whose control points are all one, as at poles, have neither and are left out.

/// Degrees, the largest angle between two legs of a row that follow each other: 0 of a straight
/// row, 180 of one that runs back on itself. nullopt if no row has two legs.
std::optional<MeasuredValue> largest_turn(const std::vector<SpanNet>& nets, double limit);

/// Degrees, the largest angle between two legs side by side in neighbouring rows. nullopt if there
/// are none.
std::optional<MeasuredValue> largest_twist(const std::vector<SpanNet>& nets, double limit);

/// The largest ratio, 1 or more, of two legs of a row that follow each other. A leg of no length
/// counts as one of SpanNet::coincidence. nullopt if no row has two legs.
std::optional<MeasuredValue> largest_ratio(const std::vector<SpanNet>& nets, double limit);

/// mm, the shortest leg of a row: control points nearer to each other are defined twice. nullopt if
/// all rows are points.
std::optional<MeasuredValue> shortest_leg(const std::vector<SpanNet>& nets, double limit);

} // namespace keiko
