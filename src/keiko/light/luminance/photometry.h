#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"

#include <numbers>

namespace KEIKO_API keiko {

/// Geometry is in mm, photometry in SI. Area lamps are scale free; point sources (I / r^2) and
/// media (extinction in 1/m) are not, and convert here and nowhere else.
constexpr double metres(double millimetres) {
    return millimetres / 1000;
}

/// One over metres from one over mm.
constexpr double per_metre(double per_millimetre) {
    return per_millimetre * 1000;
}

/// Illuminance in lx at `distance` mm from a point source of `intensity` cd. `cosine` is that of
/// the angle between the surface's normal and the direction of the light. It is 0 from behind
/// (cosine not positive) and at distance 0, where it is undefined.
inline Rgb inverse_square_illuminance(const Rgb& intensity, double distance, double cosine) {
    if (!(cosine > 0) || !(distance > 0)) return {};
    return intensity * (cosine / (metres(distance) * metres(distance)));
}

/// Luminance in cd/m2 of a diffuse surface with `reflectance` 0 to 1 under `illuminance` lx.
inline Rgb lambert_luminance(const Rgb& reflectance, const Rgb& illuminance) {
    return reflectance * illuminance / std::numbers::pi;
}

/// Luminance in cd/m2 of uniform surroundings that cause `illuminance` lx.
inline Rgb even_luminance(const Rgb& illuminance) {
    return illuminance / std::numbers::pi;
}

/// Surface luminance in cd/m2 of a diffuse tube that emits `flux` lm, from its `diameter` and
/// `length` in mm, both positive; its end caps are dark unless `luminous_caps`.
inline double tube_luminance(double flux, double diameter, double length,
                             bool luminous_caps = false) {
    const double d = metres(diameter), caps = luminous_caps ? d * d / 2 : 0;
    return flux / (std::numbers::pi * std::numbers::pi * (d * metres(length) + caps));
}

/// Luminance in cd/m2 of a diffuse surface of `area` mm2, positive, that emits `flux` lm.
inline double diffuse_luminance(double flux, double area) {
    return flux / (std::numbers::pi * metres(metres(area)));
}

} // namespace keiko
