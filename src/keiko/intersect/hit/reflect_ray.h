#pragma once

#include "keiko/intersect/hit/hit.h"

namespace keiko {

/// The ray that leaves the hit in mirror direction, excluding the hit's own root. When `incoming`
/// has differentials and the hit second derivatives, the reflected ray has them too, exact to first
/// order: transfer and reflection of [Igehy1999], with the surface's own curvature; at poles, where
/// the tangents are all but parallel, and at exact silhouettes it has none.
Ray reflect_ray(const Ray& incoming, const Hit& hit);
/// The same, put into a blank ray.
void reflect_ray(const Ray& incoming, const Hit& hit, Ray& mirrored);

} // namespace keiko
