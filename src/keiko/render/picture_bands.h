#pragma once

#include "keiko/render/picture.h"
#include "keiko/render/picture_tiles.h"
#include "keiko/trace/path_counts.h"

namespace keiko {

/// Pixels of a band, which one thread renders from top to bottom, some rows at a time. What is
/// found beyond its border is found for its neighbours again; high ones leave threads waiting at
/// the end.
constexpr int band_width = 126, band_height = 140;

/// Where Integrator::only_mirrors(): one ray a pixel, and those around the band. How many hits were
/// found in which way for its own.
PathCounts render_band(const Integrator& integrator, const PictureRays& eye,
                       const PictureTile& band, Film& film);

} // namespace keiko
