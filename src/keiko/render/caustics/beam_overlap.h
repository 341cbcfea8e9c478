#pragma once

#include "keiko/render/caustics/beam_mesh.h"
#include "keiko/render/caustics/surface_footprint.h"

namespace keiko {

/// Share of a beam's light that lands in a footprint, 0 to 1: that of its area, where the density
/// runs linearly between the corners. What a curved surface lifts a corner off the footprint's
/// plane is dropped along the normal.
double share_within(const Beam& beam, const SurfaceFootprint& footprint);

} // namespace keiko
