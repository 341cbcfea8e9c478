#pragma once

#include "keiko/intersect/hit/hit.h"

#include <optional>

namespace keiko {

/// The ray that a hit's surface bends, as long as the incoming one, excluding the hit's own root;
/// nullopt where the reflection is total. `eta`: the refractive index before the surface over that
/// behind it; 1 goes straight on. Differentials as for reflect_ray(): by transfer and refraction of
/// [Igehy1999], exact to first order.
std::optional<Ray> refract_ray(const Ray& incoming, const Hit& hit, double eta);

} // namespace keiko
