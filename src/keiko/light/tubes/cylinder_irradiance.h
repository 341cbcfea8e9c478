#pragma once

#include "keiko/light/luminance/elevations.h"
#include "keiko/light/tubes/tube_lamp.h"
#include "keiko/math/interval_set.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

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
