#pragma once

#include "keiko/math/jet.h"
#include "keiko/patch/bezier_patch.h"

#include <array>

namespace keiko {

/// Point and weight, or a derivative of both: S = p / w.
struct HomogeneousRange {
    Triple<Interval> p;
    Interval w;
};

/// d[k][l] holds d^(k+l) (p, w) / du^k dv^l, k + l <= 4, by the patch's own parameters.
using DerivativeIntervals = std::array<std::array<HomogeneousRange, 5>, 5>;

/// A patch's homogeneous derivatives: ranges that hold them all over [0, 1]^2, from the convex
/// hulls of their control points, and thin ones at its centre.
struct DerivativeRanges {
    DerivativeIntervals all, centre;
};

/// `rounding`: how far each homogeneous coordinate of a control point may be off, mm.
DerivativeRanges derivative_ranges(const BezierPatchView& patch, double rounding);

} // namespace keiko
