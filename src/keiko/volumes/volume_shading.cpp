#include "keiko/volumes/volume_shading.h"

#include <algorithm>
#include <cmath>

namespace keiko {

Vec3 volume_normal(const Vec3& gradient) {
    constexpr double none = 1e-12; // of values from 0 to 1: rounding, without a direction
    const double length = gradient.length();
    return length > none ? gradient / -length : Vec3(0);
}

ShadingTerms shading_terms(const VolumeShading& shading, const Vec3& normal, const Vec3& to_light,
                           const Vec3& to_viewer) {
    const Vec3 half = (to_light + to_viewer).normalized();
    return {shading.diffuse * std::max(0.0, normal.dot(to_light)),
            shading.specular * std::pow(std::max(0.0, normal.dot(half)), shading.exponent)};
}

Rgb shaded_luminance(const VolumeShading& shading, const ShadingTerms& terms, const Rgb& color,
                     double distance) {
    const double cue = shading.cue + shading.cue_per_length * distance;
    const Rgb lit = color * terms.diffuse + Rgb(terms.specular);
    return shading.luminance * (color * shading.ambient + lit / cue);
}

} // namespace keiko
