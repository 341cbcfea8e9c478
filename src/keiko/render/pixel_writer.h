#pragma once

#include "keiko/film/film.h"
#include "keiko/render/integrator.h"

#include <span>

namespace keiko {

/// A film without hits: black, ids -1, depth infinite.
Film blank_film(int width, int height, std::span<const Aov> aovs);

/// Writes one sample into every layer of the film.
void write_pixel(Film& film, int x, int y, const EyeSample& sample);

/// Replaces colour, coverage, luminance and illuminance of a pixel by the mean over samples,
/// `shares` of the pixel; the other layers keep what its centre shows.
void write_mean(Film& film, int x, int y, std::span<const EyeSample> samples,
                std::span<const double> shares);

} // namespace keiko
