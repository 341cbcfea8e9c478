#pragma once

#include "skin.h"

namespace keiko::fixtures {

/// Windscreen, roof, side glass and fastback as one biquintic C4 skin: columns run along the
/// car, from the cowl rearwards, rows across it, from left to right. It reaches below the body.
Skin car_greenhouse();

/// The parameters of the mirror image in y = 0 of a point of the greenhouse.
gp_XY mirrored_on_greenhouse(gp_XY uv);

} // namespace keiko::fixtures
