#pragma once

#include "keiko/light/rig/light_rig.h"

namespace keiko {

/// Whether a point (mm) lies inside the glass of one of the tubes of a source, or where a point
/// light is: what light there would be has no meaning. The glass itself is outside.
bool within_lamp(const LightSource& source, const Vec3& point);

} // namespace keiko
