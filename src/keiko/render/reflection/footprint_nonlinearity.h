#pragma once

#include "keiko/render/reflection/reflected_footprint.h"

namespace keiko {

/// How far the corners of a pixel's image on a C-plane, as the cubic through its reflected rays has
/// them, are off what the centre's differentials tell: across the lamps, in pitches, and where an
/// end of lamps may be in the image along them too, of what it spans. `plane`: where the centre's
/// ray meets it. Nothing where the ray of a corner does not.
std::optional<double> footprint_nonlinearity(const RigPlaneHit& plane, const PixelRays& rays);

} // namespace keiko
