#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// All checks of an inspection as CSV ([RFC4180], UTF-8, dots for decimals): a header, then one row
/// a seam and criterion. Numbers are in full precision and empty if nothing was judged, where the
/// verdict is "not judged".
std::string checks_csv(const Inspection& inspection);

} // namespace keiko
