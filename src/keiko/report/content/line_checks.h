#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/report/content/line_list.h"

#include <vector>

namespace keiko {

/// What the lines that cross each seam come to, in the order of views and faces: of each limit that
/// they are held to in a view the worst crossing.
std::vector<Check> line_checks(const LineList& list);

/// The inspection with the checks and findings of the lines among its own, for other programs.
Inspection with_lines(Inspection inspection, const LineList& list);

} // namespace keiko
