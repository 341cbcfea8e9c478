#pragma once

#include "keiko/film/overlay.h"

#include <string>
#include <vector>

namespace keiko {

/// Lines along which a channel of an image has the value `level`, in pixel coordinates. They are
/// short lines, one a cell of four pixel centres that is crossed, straight between linear
/// interpolations along the cell's sides. Pixels that are not finite end the lines.
std::vector<Polyline> iso_lines(const Image& values, double level, int channel = 0);

/// Lines of one value, short or long, as iso_lines finds them.
struct Contour {
    std::string label;           ///< text that stands on the lines
    std::vector<Polyline> lines; ///< in pixel coordinates
};

/// Lines that meet end to end as one each, in the order of the first of their parts; a closed one
/// ends where it begins. Their colour and width are the first part's.
std::vector<Polyline> joined_lines(const std::vector<Polyline>& parts);

/// Contours of a picture of this size, joined, each of some length broken where its label stands
/// in letters of `scale`: on its own line alone, away from other lines and labels, or nowhere.
Overlay labelled_contours(const std::vector<Contour>& contours, int width, int height, int scale);

} // namespace keiko
