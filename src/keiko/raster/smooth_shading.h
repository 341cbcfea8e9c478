#pragma once

#include "keiko/geometry/rays/ray.h"

#include <algorithm>
#include <array>

namespace keiko {

/// Shares of the corners of a triangle in the point where a ray's line meets its plane: barycentric
/// coordinates in space, so that what is mixed by them is right in perspective. Negative beside the
/// triangle; a third each for a triangle that the ray sees edge on. Each is proportional to the
/// volume that the ray spans with the opposite edge [MollerTrumbore1997, section 2].
inline Vec3 ray_weights(const std::array<Vec3, 3>& corners, const Ray& ray) {
    const Vec3 a = corners[0] - ray.origin, b = corners[1] - ray.origin,
               c = corners[2] - ray.origin;
    const Vec3 volumes(b.cross(c).dot(ray.direction), c.cross(a).dot(ray.direction),
                       a.cross(b).dot(ray.direction));
    const Vec3 weights = volumes / (volumes.x + volumes.y + volumes.z);
    return is_finite(weights) ? weights : Vec3(1.0 / 3);
}

/// Weights of a place of the triangle itself: those below 0 become 0, the others keep their ratio.
/// Of a thin facet a pixel's centre may lie far beside it, as its corners are rounded in the
/// picture. The weights must sum to 1.
inline Vec3 weights_within(const Vec3& weights) {
    const Vec3 within(std::max(weights.x, 0.0), std::max(weights.y, 0.0), std::max(weights.z, 0.0));
    return within / (within.x + within.y + within.z);
}

/// Mean of what the corners have, by their weights: a luminance by Gouraud's shading [Gouraud1971].
template <class Value>
Value mixed(const Vec3& weights, const std::array<Value, 3>& of_corners) {
    return of_corners[0] * weights.x + of_corners[1] * weights.y + of_corners[2] * weights.z;
}

/// The normals of the corners, mixed by their weights and made unit again [Phong1975].
inline Vec3 mixed_normal(const Vec3& weights, const std::array<Vec3, 3>& normals) {
    return mixed(weights, normals).normalized();
}

} // namespace keiko
