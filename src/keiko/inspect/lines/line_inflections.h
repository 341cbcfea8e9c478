#pragma once

#include "keiko/inspect/lines/lamp_levels.h"
#include "keiko/inspect/lines/line_statistics.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <vector>

namespace keiko {

/// Where a line turns over from bending one way to the other.
struct LineInflection {
    double along = 0; ///< mm, of chords, from where the line begins
    Vec3 place{0};    ///< world, mm, on the exact surface
};

/// Where the bend of the lamp's line is 0 between two of its points on a patch, at which it has
/// opposite signs; by halving on the exact surface. `along`: mm from the former.
LineInflection inflection_between(const SurfaceModel& model, const SurfaceLine& piece,
                                  const LampLevels& lamps, const LinePoint& before,
                                  const LinePoint& behind);

} // namespace keiko
