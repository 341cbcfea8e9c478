#pragma once

#include "keiko/inspect/lines/line_endpoint.h"

#include <vector>

namespace keiko {

/// Two ends that are one line: the tail of a piece and the head of the next.
struct LinePair {
    std::uint32_t tail = 0, head = 0; ///< into the meetings
};

/// Pairs of tails and heads that continue each other. Both belong to one lamp and to the two sides
/// of one border, or to different seams of a place where several meet. Their distance along the
/// border is within what the gap and the jump of the field between the sides allow, and that jump
/// is about the same at both. The nearest are joined first, each end once. Borders with more than
/// `crease` degrees are not crossed. Apart from exact ties, the result does not depend on the order
/// of the meetings.
std::vector<LinePair> pair_meetings(std::span<const LineEndpoint> meetings, double crease);

} // namespace keiko
