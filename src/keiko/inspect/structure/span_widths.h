#pragma once

#include "keiko/inspect/basics/verdict.h"
#include "keiko/inspect/structure/span_nets.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace keiko {

/// Two knots of one parameter, between which there are patches, in ascending order.
using Knots = std::pair<double, double>;
/// The patches of each knot span of one parameter.
using Spans = std::map<Knots, std::vector<const SpanNet*>>;

/// The spans of u (`in_u`) or v. They point into `nets`.
Spans spans_of(const std::vector<SpanNet>& nets, bool in_u);

/// mm, the width of the narrowest span: the longest isoline across it.
MeasuredValue knot_distance(const std::vector<SpanNet>& nets, double limit);

/// The largest ratio of the widths of two spans side by side, 1 or more. nullopt if neither
/// parameter has two spans side by side.
std::optional<MeasuredValue> largest_width_ratio(const std::vector<SpanNet>& nets, double limit);

} // namespace keiko
