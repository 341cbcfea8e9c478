#pragma once

#include "keiko/light/luminance/photometry.h"
#include "keiko/light/spotlight/beam_intensity.h"
#include "keiko/light/spotlight/beam_volume.h"
#include "keiko/light/spotlight/luminaire.h"

#include <concepts>

namespace keiko {

/// Lights without extent; each has a position and answers `intensity_towards` and `in_beam`.
template <class T>
concept PointLight = std::same_as<T, Spotlight> || std::same_as<T, Luminaire>;

/// Illuminance in lx at a `point` that sees the light, on a surface with unit `normal`; 0 from
/// behind (docs/theory/spotlights.md#frame-and-illuminance).
template <PointLight Light>
Rgb illuminance(const Light& light, const Vec3& point, const Vec3& normal) {
    const Vec3 towards = light.position - point;
    const double distance = towards.length();
    return inverse_square_illuminance(intensity_towards(light, point), distance,
                                      normal.dot(towards) / distance);
}

} // namespace keiko
