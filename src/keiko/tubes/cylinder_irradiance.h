#pragma once

#include "keiko/tubes/tube_view.h"

#include <span>

namespace keiko {

/// Another tube of the same row in the cross-section through the point: it hides what lies behind
/// it, its dark caps included.
struct HidingTube {
    double distance = 0; ///< mm, of its axis from the point; > radius
    double angle = 0;    ///< radians, from the direction of the lamp's axis towards `sideways`
};

/// Projected solid angle in sr of a part of the lateral surface of a tube, clipped by the tangent
/// plane: eq. (2.5) of physics 2.4, the inner integral in closed form and the outer by Gauss
/// between the angles at which the horizon passes over a rim, a cut or the axis direction. What the
/// tubes in `hiding`, parallel to it, of its radius and its ends, hide of it is left out (2.7).
double cylinder_solid_angle(const TubeView& view, const VisiblePart& part,
                            std::span<const HidingTube> hiding = {});

} // namespace keiko
