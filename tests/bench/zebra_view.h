#pragma once

#include "keiko/film/film.h"
#include "keiko/light/tubes/c_plane.h"
#include "keiko/scene/camera.h"

#include "tests/bench/contender.h"

namespace keiko::bench {

/// The stripes that the hits of a contender mirror, display values, 3 channels: 1 a lamp, dark
/// the body, grey where there is none. Each pixel is the mean over the same samples, so that two
/// contenders differ by their hits alone.
Image zebra_view(const Contender& contender, const Camera& camera, const CPlane& lamps);

} // namespace keiko::bench
