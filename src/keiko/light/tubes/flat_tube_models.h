#pragma once

#include "keiko/light/tubes/tube_view.h"

namespace keiko {

/// Projected solid angle in sr of a part of a lamp taken for something flat, clipped by the tangent
/// plane. TubeModel states their errors (docs/theory/luminance.md#the-ladder-of-approximations).

/// Facing rectangle by [NishitaTubes, eq. 1] with its indices corrected. As in the paper, the
/// tangent plane clips the axis only.
double seed_solid_angle(const TubeView& view, const VisiblePart& part);

/// The rectangle through the axis that faces the point, as wide as the lamp.
double rectangle_solid_angle(const TubeView& view, const VisiblePart& part);

/// A strip that covers the angle of the tube, stretched by the mean bulge pi R / 4 of the rims
/// towards the point.
double strip_solid_angle(const TubeView& view, const VisiblePart& part);

/// The axis as a line that shines with the cosine of the angle to its perpendicular, in closed
/// form.
double line_solid_angle(const TubeView& view, const VisiblePart& part);

} // namespace keiko
