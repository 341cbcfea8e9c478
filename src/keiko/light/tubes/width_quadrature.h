#pragma once

#include <span>

namespace keiko {

/// One of few half-planes that stand for the width of a lamp.
struct AcrossNode {
    double x = 0;      ///< wedge angle in half widths of the lamp, -1 to 1
    double weight = 0; ///< all together 2
    /// How far the near side, and with it the rims at the ends, stands out of the axis, in radii:
    /// the circle at x, scaled so that the mean over the rule is the circle's, pi / 4. So few nodes
    /// of Gauss's miss that by up to a quarter, an error of first order in d / D.
    double rim = 0;
};

/// Gauss's rule of 1, 2 or 4 nodes.
std::span<const AcrossNode> width_quadrature(int nodes);

} // namespace keiko
