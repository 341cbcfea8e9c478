#pragma once

#include "keiko/light/rig/light_rig.h"

#include <span>
#include <vector>

namespace keiko {

/// Corners of a box around some lamps of a source, by rising number, and those between them: all
/// that a surface may be lit from, mm.
std::vector<Vec3> light_bounds(const LightSource& source, std::span<const int> lamps,
                               const Vec3& point);

/// Corners of a convex body around all that a point asks for of one lamp of a source: of a tube its
/// axis, or where shadows are weighed over its width all of it.
std::vector<Vec3> lamp_corners(const LightSource& source, int lamp, const Vec3& point,
                               TubeModel model);

} // namespace keiko
