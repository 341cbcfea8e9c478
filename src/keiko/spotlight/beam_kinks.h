#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/spotlight/spotlight.h"

#include <vector>

namespace keiko {

/// Parameters of a segment, rising, between which the pattern and the hue of a beam are smooth but
/// for where negative q cuts petals and dots off: its crossings with the borders and middles of
/// their periods.
std::vector<double> pattern_kinks(const Spotlight& light, const Segment& segment);

} // namespace keiko
