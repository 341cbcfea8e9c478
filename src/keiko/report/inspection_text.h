#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// An inspection for people at a terminal: the verdict with its counts, then up to `most` findings,
/// the worst first, a line each.
std::string inspection_text(const Inspection& inspection, std::size_t most = 20);

} // namespace keiko
