#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/spotlight/luminaire.h"
#include "keiko/light/spotlight/spotlight.h"

namespace keiko {

/// Parts of a segment inside a spotlight's cone, round or elliptic, parameters 0 to 1
/// (docs/theory/fog.md#lit-parts). Half angles of 90 degrees and more leave a dark cone behind the
/// lamp; 180 and more light all of it.
IntervalSet in_beam(const Spotlight& light, const Segment& segment);

/// Parts of a segment inside the round cone around the axis of a luminaire's angles beyond which
/// its file is dark; all of it for types A and B.
IntervalSet in_beam(const Luminaire& luminaire, const Segment& segment);

} // namespace keiko
