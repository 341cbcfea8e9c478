#pragma once

#include "keiko/film/overlay.h"
#include "keiko/inspect/inspection.h"
#include "keiko/scene/camera.h"
#include "keiko/workflow/curve_painter.h"

namespace keiko {

/// Adds a stretch of a seam as a row of dots, between which its reflection is seen.
void dot_seam(const MeasuredSeam& seam, const CurvePainter& painter, Overlay& overlay);

/// Adds a ring of dots about an opening, whose rim may be as dark as what lies behind it.
void ring_opening(const Check& opening, const Camera& camera, Overlay& overlay);

/// Adds a bar of a round length at the lower left, and the length. It holds at `place`, world, mm,
/// square to the line of sight.
void add_scale_bar(const Camera& camera, const Vec3& place, Overlay& overlay);

} // namespace keiko
