#pragma once

#include "keiko/render/lighting/interpolation_errors.h"
#include "keiko/render/lighting/light_samples.h"
#include "keiko/render/lighting/pixel_rectangle.h"

namespace keiko {

/// Lights, of some that have been found there, that corners and middles of a rectangle of a grid
/// all see as a whole.
Lights classify_prisms(const LightSamples& found, const Rectangle& r, const Lights& lights);

/// Lights, of some, of which it is not proved that all places of a rectangle see the same: all of
/// them or nothing.
Lights possibly_occluded_lights(const Integrator& integrator, const ShadingGrid& grid,
                                const Rectangle& r, const Lights& lights);

} // namespace keiko
