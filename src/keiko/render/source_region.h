#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/light_rig.h"

#include <vector>

namespace keiko {

/// Corners of a box around all of a light source that a surface may be lit from, mm.
std::vector<Vec3> source_region(const LightSource& source, const Vec3& point);

/// The axes of its lamps, by rising v; none for a source without extent.
std::vector<Segment> source_segments(const LightSource& source);

} // namespace keiko
