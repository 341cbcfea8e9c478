#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// Everything that was held against the preset as CSV ([RFC4180], UTF-8, dots for decimals): a
/// header, then one row a seam and criterion. Numbers are in full precision and empty where nothing
/// was judged, whose verdict is "not judged".
std::string checks_csv(const Inspection& inspection);

} // namespace keiko
