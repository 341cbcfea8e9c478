#pragma once

#include "keiko/inspect/lines/lamp_levels.h"
#include "keiko/inspect/lines/line_statistics.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <vector>

namespace keiko {

/// A change of sign of a line's curvature.
struct LineInflection {
    double along = 0; ///< mm, of chords, from where the line begins
    Vec3 place{0};    ///< world, mm, on the exact surface
};

/// Zero of the curvature of the lamp's line between two of its points on a patch, at which it has
/// opposite signs; by halving on the exact surface. `along`: mm from the former.
LineInflection inflection_between(const SurfaceModel& model, const SurfaceLine& piece,
                                  const LampLevels& lamps, const LinePoint& before,
                                  const LinePoint& behind);

} // namespace keiko
