#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <vector>

namespace keiko {

/// Shares of an isoline at which the surface across it is sampled.
constexpr std::array<double, 3> isoline_samples{0.11, 0.5, 0.87};

/// The isolines of a patch at which its surface could bend within `window` mm: where |S_u|, the
/// speed across, is least. As |S_uu| <= 2 (n - 1)^2 max |S_u| (Markov) of degree n, no line turns
/// within w that is faster than (n - 1) sqrt(2 w max |S_u|); of a slow one the speed must rise by
/// a quarter within half a window. A patch no wider than the window has one in its middle.
/// Parameters in [0, 1], rising: of u where `constant_u`, else of v. Speeds are sampled in 4 n
/// steps at three places of the line, so minima closer together may be missed.
std::vector<double> slow_lines(const BezierPatchView& patch, bool constant_u, double window);

} // namespace keiko
