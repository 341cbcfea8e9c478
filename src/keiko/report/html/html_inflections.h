#pragma once

#include "keiko/report/content/line_list.h"

#include <string>

namespace keiko {

/// Where the lines turn over, in a table under a line that opens it; empty where none does.
std::string html_inflections(const LineList& list);

} // namespace keiko
