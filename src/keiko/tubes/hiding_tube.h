#pragma once

#include "keiko/tubes/tube_view.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Another tube of the same row in the cross-section through the point: it hides what lies behind
/// it, its dark caps included.
struct HidingTube {
    double distance = 0; ///< mm, of its axis from the point; within the radius beyond an end alone
    double angle = 0;    ///< radians, from the direction of the lamp's axis towards `sideways`

    /// Half of the wedge that the endless tube of this radius takes, radians; nothing where the
    /// point is within that: it takes all directions.
    std::optional<double> half_wedge(double radius) const;
};

/// Elevations towards the lamp's end b, radians, that tubes nearer than `near` mm take in the
/// half-plane at the wedge angle `psi`, in any order. The tubes are parallel to the lamp that
/// `view` shows, of its radius and its ends (physics 2.7).
std::vector<ParameterInterval> hidden_elevations(const TubeView& view,
                                                 std::span<const HidingTube> hiding, double psi,
                                                 double near);

} // namespace keiko
