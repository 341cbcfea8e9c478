#pragma once

#include "keiko/report/content/report.h"

#include <string>

namespace keiko {

/// The report for people: one HTML page that needs no other file, pictures included.
std::string report_html(const Report& report);

} // namespace keiko
