#pragma once

#include "keiko/inspect/check.h"

#include <string>

namespace keiko {

/// "seam 3 (face 1 | face 2)", whose number is that of the report's table, from 1; "face 1"; "lines
/// over face 1 | face 2 in view front".
std::string subject_of(const Check& check);

/// "face 1 | face 2: the gap of ... is over the limit of ..., at 50.0, 0.0, 0.0"; the place in mm.
std::string placed_message(const Check& check);

} // namespace keiko
