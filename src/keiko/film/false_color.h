#pragma once

#include "keiko/film/film.h"

namespace keiko {

/// A logarithmic scale of luminance in cd/m2 or illuminance in lx.
struct FalseColorScale {
    double minimum = 1, maximum = 10000; ///< 0 < minimum < maximum
};

/// Place of `value` on the scale, 0 to 1, by its logarithm; 0 for what is not positive.
double scale_position(const FalseColorScale& scale, double value);

/// Blue, cyan, green, yellow, red at 0, 1/4, 1/2, 3/4, 1, linear between; display values.
Rgb jet(double position);

/// Luminance of a film's colour in cd/m2, 1 channel.
Image luminance_of(const Film& film);

/// Display picture of 3 channels from one channel of an image.
Image false_color(const Image& values, const FalseColorScale& scale, int channel = 0);
/// The same from a film's luminance.
Image false_color(const Film& film, const FalseColorScale& scale);

} // namespace keiko
