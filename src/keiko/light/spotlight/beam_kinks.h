#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/spotlight.h"

#include <vector>

namespace keiko {

/// Parameters of a segment, rising, between which the intensity of a beam is smooth but for where
/// negative q cuts petals and dots off: its crossings with the borders and middles of the pattern's
/// periods, with sixths of the hue circle, and with the angles of a table.
std::vector<double> intensity_kinks(const Spotlight& light, const Segment& segment);

/// The same of a luminaire, whose intensity is linear between the angles of its file.
std::vector<double> intensity_kinks(const Luminaire& luminaire, const Segment& segment);

} // namespace keiko
