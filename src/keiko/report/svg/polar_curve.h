#pragma once

#include "keiko/report/content/luminaire_facts.h"

#include <string>

namespace keiko {

/// The polar curve of a luminaire as an SVG picture in the form of catalogues: the axis of its
/// angles points down, and the distance from the middle is the intensity in cd. A full line is the
/// plane of H = 0 and 180 (for types A and B the plane of the axis that holds the horizontal). A
/// dashed line is the plane across. The right half is that of H = 0 and 90.
std::string polar_curve_svg(const LuminaireFacts& facts);

} // namespace keiko
