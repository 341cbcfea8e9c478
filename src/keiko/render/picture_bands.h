#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/render/shading/picture.h"
#include "keiko/render/tiles.h"

#include <vector>

namespace keiko {

/// The picture in bands, each of which one thread renders from top to bottom, some rows at a time.
/// What is found beyond the border of one is found for its neighbours again, so they are as high as
/// leaves enough of them for that many threads.
std::vector<Tile> picture_bands(const Camera& camera, std::size_t threads);

/// Where Integrator::only_mirrors(): one ray a pixel, and those around the band. How many hits were
/// found in which way for its own.
HitStatistics render_band(const Integrator& integrator, const PictureRays& eye, const Tile& band,
                          Film& film);

} // namespace keiko
