#pragma once

#include "keiko/light/rig/light_rig.h"
#include "keiko/math/rgb.h"

#include <vector>

namespace keiko {

/// The level of each source of a rig: the luminance (cd/m2), intensity (cd), illuminance (lx) or
/// factor that all of its light is proportional to, in each channel.
std::vector<Rgb> levels_of(const LightRig& rig);

/// The rig with all levels 1. The ground of a sky keeps its share of the zenith's luminance.
LightRig at_unit_levels(LightRig rig);

} // namespace keiko
