#pragma once

#include "keiko/geometry/model/primitive.h"
#include "keiko/light/rig/light_rig.h"

#include <vector>

namespace keiko {

/// The lights of a primitive that shines outwards with one luminance, in cd/m2: a sphere or an
/// ellipsoid; a lateral surface and the discs of its ends; a disc; a panel, or six of them.
std::vector<LightSource> lights_of(const PrimitiveShape& shape, const Rgb& luminance);

} // namespace keiko
