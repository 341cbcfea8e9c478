#pragma once

#include "keiko/render/grid_lights.h"
#include "keiko/render/light_doubts.h"
#include "keiko/render/pixel_rectangle.h"

namespace keiko {

/// Lights, of some that have been found there, that all corners and middles of a rectangle of a
/// grid see as a whole though something may come between them and some other place of it.
Lights threatened_lights(const Integrator& integrator, const SpotGrid& grid,
                         const GridLights& found, const Rectangle& r, const Lights& lights);

} // namespace keiko
