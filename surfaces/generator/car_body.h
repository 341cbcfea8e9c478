#pragma once

#include "skin.h"

namespace keiko::fixtures {

/// Lower body, one closed biquintic C4 skin around the car. Columns run from the middle of the nose
/// (u = 0) along the right side to the tail (half the columns) and back along the left. Rows run
/// from the sill over flank and shoulder to a rim hidden under the greenhouse.
Skin car_body();

/// The parameters of the mirror image in y = 0 of a point of the body.
gp_XY mirrored_on_body(gp_XY uv);

} // namespace keiko::fixtures
