#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <span>
#include <vector>

namespace keiko {

/// Parameter of the line of a patch that is no wider than the window.
constexpr double middle_of_narrow = 0.5;

/// The isolines of a patch at which its surface could bend within `window` mm: where the speed
/// square to the isoline, |S_u x S_v| / |S_v|, is least. This is a heuristic. A bend within w is
/// expected only of lines slower than (n - 1) sqrt(2 w m) of degree n, m the largest speed. The
/// speed beside a slow line must also rise by a quarter within half a window. The limit is
/// motivated by Markov's inequality, which is for polynomials and bounds the change of S_u roughly;
/// rational patches are treated alike. A patch no wider than the window has one in its middle.
/// Parameters in [0, 1], rising: of u if `constant_u`, else of v. Speeds are sampled in 4 n steps
/// at the places `along` the line, so minima closer together may be missed.
std::vector<double> slow_lines(const BezierPatchView& patch, bool constant_u,
                               std::span<const double> along, double window);

} // namespace keiko
