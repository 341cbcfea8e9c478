#pragma once

#include "keiko/geometry/rays/ray.h"

#include <cmath>
#include <optional>

namespace keiko {

/// Surface that a ray meets, in truth or as something else has it.
struct MetSurface {
    double t = 0;   ///< of the ray, in lengths of its direction
    Vec3 normal{0}; ///< unit, of either side
};

/// Displacement, mm, of the image of a lamp `distance` mm along the mirrored ray: the distance
/// between the ray that is mirrored in truth and the one that `shown` mirrors, across the former.
/// The ray's direction is unit.
inline double mirror_displacement(const Ray& ray, const MetSurface& truth, const MetSurface& shown,
                                  double distance) {
    const auto at_lamps = [&](const MetSurface& met) {
        return ray.at(met.t) + reflect(ray.direction, met.normal) * distance;
    };
    return square_to(at_lamps(shown) - at_lamps(truth), reflect(ray.direction, truth.normal))
        .length();
}

/// Edge of a pixel's image `distance` mm along its mirrored ray, mm: the mean of both edges, by
/// differentials; nullopt without these. The direction is unit.
inline std::optional<double> mirrored_pixel(const Ray& mirrored, double distance) {
    if (!mirrored.differentials) return std::nullopt;
    const RayDifferentials& d = *mirrored.differentials;
    const Vec3 dx = square_to(d.origin_dx + d.direction_dx * distance, mirrored.direction);
    const Vec3 dy = square_to(d.origin_dy + d.direction_dy * distance, mirrored.direction);
    return (dx.length() + dy.length()) / 2;
}

/// Angle between two normals of either side, radians, 0 to pi / 2.
inline double normal_error(const Vec3& a, const Vec3& b) {
    return angle_between(a, a.dot(b) < 0 ? -b : b);
}

} // namespace keiko
