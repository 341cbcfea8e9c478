#pragma once

#include "keiko/light/spotlight/photometric_web.h"
#include "keiko/light/spotlight/spotlight.h"

namespace keiko {

/// Luminous flux of the lamp in lm, by channel: the integral of its intensity over all directions,
/// piecewise between the angles of its table and its pattern, exact up to rounding.
Rgb luminous_flux(const Spotlight& light);

/// Luminous flux of a luminaire file in lm: the integral of its intensities, exact up to rounding.
double luminous_flux(const PhotometricWeb& web);

/// Luminous flux below the horizontal in lm. The web must be of type C.
double downward_flux(const PhotometricWeb& web);

} // namespace keiko
