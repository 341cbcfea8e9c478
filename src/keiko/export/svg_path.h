#pragma once

#include "keiko/math/vec.h"

#include <string>
#include <vector>

namespace keiko {

/// Data of an SVG path along lines of two points at least, y upwards from the lower side of a
/// picture of that height. Numbers have `decimals` of 1 or 2, and points that they make one are
/// left out.
std::string svg_path(const std::vector<std::vector<Vec2>>& lines, double height, int decimals);

} // namespace keiko
