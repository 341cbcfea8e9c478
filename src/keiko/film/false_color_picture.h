#pragma once

#include "keiko/film/false_color.h"

#include <string>
#include <vector>

namespace keiko {

/// Values that a legend names: powers of ten, and 2 and 5 times these where there is room; both
/// ends of the scale are among them when they are round.
std::vector<double> round_values(const FalseColorScale& scale);

/// A film's luminance in false colour with a legend at its right, in the manner of Radiance's
/// falsecolor: the colours of the scale from the maximum down, its round values and the unit. With
/// `lines`, black lines of equal luminance at these values.
Image false_color_picture(const Film& film, const FalseColorScale& scale, bool lines);

} // namespace keiko
