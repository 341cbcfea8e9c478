#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// Counts of the stretches of seams: "stretches of seams 1 fail, 0 undecided, 2 pass, 0 creases,
/// 1 scrap (of 3 seams); 1.5 of 20.0 mm of borders meet no other".
std::string seams_words(const Inspection& inspection);

/// An inspection for people at a terminal: the verdict with its counts, then up to `most` findings,
/// the worst first, a line each.
std::string inspection_text(const Inspection& inspection, std::size_t most = 20);

} // namespace keiko
