#pragma once

#include "keiko/film/film.h"
#include "keiko/render/shading/integrator.h"

#include <span>

namespace keiko {

/// A film without hits: black, ids -1, depth infinite.
Film blank_film(int width, int height, std::span<const Aov> aovs);

/// Writes one sample a pixel into every layer of the film, for pixels of a row from (x, y) on.
void write_row(Film& film, int x, int y, std::span<const PixelSample> samples);

/// Replaces colour, coverage, luminance and illuminance of a pixel by the mean over samples,
/// `shares` of the pixel; the other layers keep the values of its centre.
void write_mean(Film& film, int x, int y, std::span<const PixelSample> samples,
                std::span<const double> shares);

} // namespace keiko
