#pragma once

#include "keiko/light/tubes/occluding_tube.h"

namespace keiko {

/// Projected solid angle in sr of a part of the lateral surface of a tube, clipped by the tangent
/// plane (docs/theory/luminance.md#a-tube). The inner integral is in closed form, the outer by
/// Gauss's rule between the angles at which the horizon passes over a rim, a cut or the axis
/// direction. What the tubes in `hiding`, parallel to it, of its radius and its ends, hide of it is
/// left out (docs/theory/luminance.md#lamps-that-hide-each-other).
double cylinder_solid_angle(const TubeView& view, const VisiblePart& part,
                            std::span<const OccludingTube> hiding = {});

} // namespace keiko
