#pragma once

#include "keiko/light/tubes/tube_view.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// Another tube of the same row in the cross-section through the point: it hides what lies behind
/// it, its dark caps included.
struct OccludingTube {
    double distance = 0; ///< mm, of its axis from the point; within the radius beyond an end alone
    double angle = 0;    ///< radians, from the direction of the lamp's axis towards `sideways`

    /// Wedge angles, radians, beside which what the tube hides bends most sharply: those of the
    /// half-planes that touch it or, where the point is within its extension, of those across the
    /// way to its axis.
    std::array<double, 2> kinks(double radius) const;
};

/// Elevations towards the lamp's end b, radians, that tubes nearer than `near` mm take in the
/// half-plane at the wedge angle `psi`, in any order. The tubes are parallel to the lamp that
/// `view` shows, of its radius and its ends (docs/theory/luminance.md#lamps-that-hide-each-other).
std::vector<ParameterInterval> hidden_elevations(const TubeView& view,
                                                 std::span<const OccludingTube> hiding, double psi,
                                                 double near);

} // namespace keiko
