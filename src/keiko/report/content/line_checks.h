#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/report/content/line_list.h"

#include <vector>

namespace keiko {

/// Checks of the lines that cross each seam, in the order of views and faces: the worst crossing
/// for each limit of a view.
std::vector<Check> line_checks(const LineList& list);

/// The inspection with the checks and findings of the lines among its own, for other programs.
Inspection with_lines(Inspection inspection, const LineList& list);

} // namespace keiko
