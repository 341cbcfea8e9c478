#pragma once

#include "keiko/inspect/inspection.h"

#include <string>

namespace keiko {

/// "798.8 of 798.8 mm of borders meet no other": borders that no seam judges. Empty where all meet
/// but for what rounding leaves.
std::string unmet_borders(const ModelFacts& facts);

/// Of a body of several faces without any seam: that nothing was judged, and within which distance
/// seams were sought. Else empty.
std::string nothing_judged(const Inspection& inspection);

} // namespace keiko
