#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// Length of free edges, which no seam judges, in words: "798.8 of 798.8 mm of borders meet no
/// other". Empty if all borders meet to within rounding.
std::string unmet_borders(const ModelFacts& facts);

/// Statement that nothing was judged, for a body of several faces without any seam, with the
/// distance within which seams were searched. Else empty.
std::string nothing_judged(const Inspection& inspection);

} // namespace keiko
