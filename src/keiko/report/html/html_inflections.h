#pragma once

#include "keiko/report/content/line_list.h"

#include <string>

namespace keiko {

/// Inflections of the lines, in a table under a line that opens it; empty if there are none.
std::string html_inflections(const LineList& list);

} // namespace keiko
