#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/light_rig.h"

#include <span>
#include <vector>

namespace keiko {

/// Corners of a box around some lamps of a source, by rising number, and those between them: all
/// that a surface may be lit from, mm.
std::vector<Vec3> source_region(const LightSource& source, std::span<const int> lamps,
                                const Vec3& point);

/// The axes of those lamps; none for a source without extent.
std::vector<Segment> source_segments(const LightSource& source, std::span<const int> lamps);

} // namespace keiko
