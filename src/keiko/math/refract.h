#pragma once

#include "keiko/math/vec.h"

#include <cmath>
#include <optional>

namespace keiko {

/// Direction of light behind an interface that it meets in unit direction `d`: `normal` is the unit
/// normal on the side it comes from, `eta` the index before the interface over that behind it.
/// nullopt if the reflection is total (docs/theory/luminance.md#fresnel-reflectance).
inline std::optional<Vec3> refract(const Vec3& d, const Vec3& normal, double eta) {
    const double cosine = -d.dot(normal);
    const double square = 1 - eta * eta * (1 - cosine * cosine);
    if (square < 0) return {};
    return d * eta + normal * (eta * cosine - std::sqrt(square));
}

} // namespace keiko
