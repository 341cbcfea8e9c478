#pragma once

#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace keiko {

// Elevations eta from the perpendicular to an axis, towards its end b, are given by the tangents of
// half of them, which are found without angles and lie in [-1, 1].

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
    if (al > 0 || nz > 0) lit.begin = std::max(lit.begin, -al / (nz + length));
    if (al > 0 || nz < 0) lit.end = std::min(lit.end, -al / (nz - length));
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

/// Another tube of the same row in the cross-section through the point. It hides everything behind
/// it, and its dark caps do too.
struct OccludingTube {
    double distance = 0; ///< mm, of its axis from the point; within the radius beyond an end alone
    double angle = 0;    ///< radians, from the direction of the lamp's axis towards `sideways`

    /// Wedge angles, radians, near which the hidden part bends most sharply. They are those of the
    /// half-planes that touch the tube or, if the point is within its extension, of those across
    /// the direction to its axis.
    std::array<double, 2> kinks(double radius) const;
};

/// Elevations, by half tangents, that tubes nearer than `near` mm occupy in the half-plane at the
/// wedge angle `psi`, in any order. The tubes are parallel to the lamp of `view`,
/// of its radius and its ends (docs/theory/luminance.md#lamps-that-hide-each-other).
std::vector<ParameterInterval> hidden_elevations(const TubeView& view,
                                                 std::span<const OccludingTube> hiding, double psi,
                                                 double near);

/// Projected solid angle in sr of a part of the lateral surface of a tube, clipped by the tangent
/// plane (docs/theory/luminance.md#a-tube). The inner integral is in closed form. The outer is
/// Gauss's rule with `nodes` between two of the angles at which the horizon passes over a rim, a
/// cut or the axis direction. With 16 it is exact to rounding for d/D up to 1. With 8 the error is
/// 1e-2 at most for d/D up to 1.9, and 1e-5 in the mean. Parts hidden by the tubes in `hiding`,
/// parallel to it, of its radius and its ends, are left out
/// (docs/theory/luminance.md#lamps-that-hide-each-other).
double cylinder_solid_angle(const TubeView& view, const VisiblePart& part,
                            std::span<const OccludingTube> hiding = {}, int nodes = 16);

} // namespace keiko
