#pragma once

#include "keiko/report/content/luminaire_facts.h"

#include <string>

namespace keiko {

/// The polar curve of a luminaire as an SVG picture, as catalogues have it: the axis of its angles
/// downwards, intensity in cd as distance from the middle, a full line for the plane of H = 0 and
/// 180 (of types A and B the plane of the axis that holds the horizontal) and a dashed one for the
/// plane across. The right half is that of H = 0 and 90.
std::string polar_curve_svg(const LuminaireFacts& facts);

} // namespace keiko
