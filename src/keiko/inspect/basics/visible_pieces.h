#pragma once

#include "keiko/inspect/basics/zero_function.h"

#include <functional>

namespace keiko {

/// The pieces of a line on which `visible` holds. The predicate is evaluated at the line's points
/// and at points between them at most about `step` mm apart, so that a change and its reverse
/// within one step may be missed. Where its value changes, the place is bisected on the line to
/// 1e-9 mm, and the piece ends on the visible side. A closed line that is visible as a whole stays
/// closed.
std::vector<PatchLine> visible_pieces(const PatchLine& line, const ZeroFunction& f, double step,
                                      const std::function<bool(const LinePoint&)>& visible);

} // namespace keiko
