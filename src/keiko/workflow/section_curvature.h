#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"

namespace KEIKO_API keiko {

/// Curvatures of normal sections at the middle of each pixel, 1/mm, 1 channel: along the plane
/// through the place with the normal `plane` (finite, not 0). They are positive in hollows as
/// viewed from the camera, and not a number without a surface, where the plane touches it, and
/// where rounding leaves less than three digits. The tracer must have second derivatives. Throws
/// Cancelled.
Image section_curvatures(const Tracer& body, const Camera& camera, const Vec3& plane,
                         const Job& job = {});

} // namespace keiko
