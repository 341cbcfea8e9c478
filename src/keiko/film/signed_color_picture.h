#pragma once

#include "keiko/film/film.h"
#include "keiko/film/value_range.h"

namespace keiko {

/// Display colour of a signed share: from -1 (deep blue) over 0 (light grey) to 1 (deep red).
Rgb signed_color(double share);

/// Share of the reach of a range's colours: 0 at 0, or at the end that is nearest to it, and 1 or
/// -1 at the ends of the range; beyond them more.
double signed_share(double value, const ValueRange& range);

/// Display picture of signed values (1 channel) with a legend at its right: blue below, grey at,
/// red above 0, full at the ends of the range, in `unit`. A range on one side of 0 has the colours
/// of that side. Infinite values are magenta, what is no number is dark grey on the body and darker
/// beside it. `facing` (1 channel, 0 to 1) shades it, so that the form shows.
Image signed_color_picture(const Image& values, const Image& facing, const ValueRange& range,
                           const std::string& unit);

/// The round number (1, 2 or 5 times a power of ten) at or above a positive value.
double round_scale(double value);

} // namespace keiko
