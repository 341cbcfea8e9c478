#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/render/shading/picture.h"
#include "keiko/render/tiles.h"

#include <vector>

namespace keiko {

/// The picture in bands, each rendered by one thread from top to bottom, some rows at a time.
/// Results beyond the border of a band are computed for its neighbours again, so bands are as high
/// as leaves enough of them for that many threads.
std::vector<Tile> picture_bands(const Camera& camera, std::size_t threads);

/// Renders a band if Integrator::only_mirrors(): one ray a pixel, and those around the band.
/// Returns the statistics of the hits of its own pixels.
HitStatistics render_band(const Integrator& integrator, const PictureRays& eye, const Tile& band,
                          Film& film);

} // namespace keiko
