#pragma once

#include "keiko/film/overlay.h"

namespace keiko {

/// Lines through a channel of an image along which it has the value `level`, in pixel coordinates:
/// one short line a cell of four pixel centres that it crosses, straight between linear
/// interpolations along the cell's sides. Pixels that are not finite end the lines.
std::vector<Polyline> iso_lines(const Image& values, double level, int channel = 0);

} // namespace keiko
