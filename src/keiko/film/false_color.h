#pragma once

#include "keiko/base/export.h"
#include "keiko/film/film.h"

#include <string>
#include <vector>

namespace KEIKO_API keiko {

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
/// Display picture of 3 channels from a film's luminance.
Image false_color(const Film& film, const FalseColorScale& scale);

/// Quantity that false colours stand for.
enum class ShownQuantity {
    luminance,  ///< cd/m2
    illuminance ///< lx
};

/// "cd/m2" or "lx".
std::string_view unit_of(ShownQuantity quantity);

/// Values that a legend names: powers of ten, and where there is room 2 and 5 times these. A scale
/// of at most 1.7 decades has the steps of lighting standards instead (1, 1.5, 2, 3, 5, 7.5). Both
/// ends of the scale are among them when they are round.
std::vector<double> round_values(const FalseColorScale& scale);

/// A film in false colour with a legend at its right, in the manner of Radiance's falsecolor: the
/// colours of the scale from the maximum down, its round values and the unit. Lines of letters grow
/// with the picture. With `lines`, black lines of equal value at these values, the longer ones with
/// their number on them. Of illuminance, which the film must hold as an AOV, only what shows the
/// model is coloured. Throws Error for a film without it.
Image false_color_picture(const Film& film, const FalseColorScale& scale, bool lines,
                          ShownQuantity quantity = ShownQuantity::luminance);

} // namespace keiko
