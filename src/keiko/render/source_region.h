#pragma once

#include "keiko/rig/light_rig.h"

#include <span>
#include <vector>

namespace keiko {

/// Corners of a box around some lamps of a source, by rising number, and those between them: all
/// that a surface may be lit from, mm.
std::vector<Vec3> source_region(const LightSource& source, std::span<const int> lamps,
                                const Vec3& point);

} // namespace keiko
