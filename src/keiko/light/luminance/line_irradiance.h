#pragma once

namespace keiko {

/// A piece of a straight line as a surface element sees it: positions x along the line count from
/// the foot of the element, whose unit normal has the components `n_along` along the line and
/// `n_line` towards the foot. Lengths in one unit of any kind.
struct LinePiece {
    double begin = 0, end = 0;
    double distance = 0; ///< of the element from the line, > 0
    double n_along = 0, n_line = 0;
};

/// The piece above the element's horizon; empty (begin >= end) where there is none.
LinePiece above_horizon(const LinePiece& piece);

/// Integral of (N.w) cos(angle to the perpendicular) / r^2 along a piece that lies above the
/// horizon, in one over the unit of length, to 1e-11. Times the intensity per length across the
/// line, in cd/m, it is the illuminance of a thin diffuse tube, the line source of [Nishita1985]
/// (docs/theory/luminance.md#the-ladder-of-approximations).
double cosine_line_integral(const LinePiece& piece);

} // namespace keiko
