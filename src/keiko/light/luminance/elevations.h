#pragma once

#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>

namespace keiko {

// A half-plane through a point is bounded by a line through it, the axis. Elevations eta in it
// count from the perpendicular to the axis. They are given by the tangents of half of them, which
// are found without angles and lie in [-1, 1].

/// Half tangent of the elevation of a place at `x` mm along the axis and `r` mm, 0 or more, from
/// the parallel to it through the point; 0 where both are 0.
inline double half_tangent(double x, double r) {
    const double sum = r + std::sqrt(x * x + r * r);
    return sum > 0 ? x / sum : 0;
}

/// Elevations of [low, high] over the horizon al cos eta + nz sin eta = 0; empty (begin >= end) if
/// there are none.
inline ParameterInterval above_horizon(double al, double nz, ParameterInterval lit) {
    const double length = std::sqrt(al * al + nz * nz);
    // Of both forms of each end one has a difference of two numbers that may be alike.
    if (al > 0 || nz > 0)
        lit.begin = std::max(lit.begin, nz < 0 ? (nz - length) / al : -al / (nz + length));
    if (al > 0 || nz < 0)
        lit.end = std::min(lit.end, nz > 0 ? (nz + length) / al : -al / (nz - length));
    if (!(al > 0) && nz == 0) lit.end = lit.begin;
    return lit;
}

/// Integral of (al cos eta + nz sin eta) cos eta over some elevations where it is positive
/// (docs/theory/luminance.md#a-tube).
inline double arc_integral(double al, double nz, const ParameterInterval& elevations) {
    const auto [low, high] = above_horizon(al, nz, elevations);
    if (!(low < high)) return 0;
    // Cosine and sine of half the span and of half the sum, over one length.
    const double u = 1 + low * high, v = high - low, x = 1 - low * high, y = low + high;
    const double scale = 1 / (u * u + v * v), sine = 2 * u * v * scale; // of the span
    return al * (std::atan2(v, u) + (x - y) * (x + y) * scale * sine / 2) +
           nz * x * y * scale * sine;
}

} // namespace keiko
