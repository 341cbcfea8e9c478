#pragma once

#include "keiko/spotlight/photometric_web.h"
#include "keiko/spotlight/spotlight.h"

namespace keiko {

/// Luminous flux of the lamp in lm, by channel: the integral of its intensity over all directions,
/// exact up to rounding but for elliptic beams with a pattern.
Rgb luminous_flux(const Spotlight& light);

/// Of a luminaire file, lm.
double luminous_flux(const PhotometricWeb& web);

} // namespace keiko
